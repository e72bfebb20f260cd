#pragma once
// JSON Schema of the texts of SPEC section 8. Private to this folder.

namespace groundtruth::report {

inline constexpr const char* vector_schema = R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Groundtruth: lines of asks and answers",
  "$defs": {
    "number": {"anyOf": [{"type": "number"}, {"type": "string", "pattern": "^-?0[xX]"}]},
    "vector": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 3, "maxItems": 3},
    "quaternion": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 4, "maxItems": 4},
    "id": {"type": ["string", "number", "null"]},
    "shape": {"anyOf": [
      {"enum": ["everything", "nothing"]},
      {"type": "object", "required": ["halfspace"], "additionalProperties": false, "properties": {
        "halfspace": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 4, "maxItems": 4}}},
      {"type": "object", "required": ["box"], "additionalProperties": false, "properties": {
        "box": {"type": "array", "items": {"$ref": "#/$defs/vector"}, "minItems": 2, "maxItems": 2}}},
      {"type": "object", "required": ["union"], "additionalProperties": false, "properties": {
        "union": {"type": "array", "items": {"$ref": "#/$defs/shape"}}}},
      {"type": "object", "required": ["intersection"], "additionalProperties": false, "properties": {
        "intersection": {"type": "array", "items": {"$ref": "#/$defs/shape"}}}},
      {"type": "object", "required": ["material", "shape"], "additionalProperties": false, "properties": {
        "material": {"type": "string"}, "shape": {"$ref": "#/$defs/shape"}}},
      {"type": "object", "required": ["paint", "where", "shape"], "additionalProperties": false, "properties": {
        "paint": {"type": "string"}, "where": {"$ref": "#/$defs/shape"}, "shape": {"$ref": "#/$defs/shape"}}}]},
    "friction": {"type": "object", "required": ["static", "dynamic"], "additionalProperties": false, "properties": {
      "static": {"$ref": "#/$defs/number"}, "dynamic": {"$ref": "#/$defs/number"}}},
    "material": {"type": "object", "additionalProperties": false, "properties": {
      "friction": {"type": "object", "additionalProperties": {"$ref": "#/$defs/friction"}},
      "max_force": {"anyOf": [{"$ref": "#/$defs/number"}, {"type": "null"}]}}},
    "scene": {"type": "object", "required": ["groundtruth", "shape"], "additionalProperties": false, "properties": {
      "groundtruth": {"const": "scene/1"}, "shape": {"$ref": "#/$defs/shape"},
      "materials": {"type": "object", "additionalProperties": {"$ref": "#/$defs/material"}}}},
    "state": {"anyOf": [
      {"type": "object", "required": ["kind"], "additionalProperties": false,
       "properties": {"kind": {"const": "free"}}},
      {"type": "object", "required": ["kind", "pebble", "velocity", "normal", "static", "dynamic"],
       "additionalProperties": false, "properties": {
        "kind": {"enum": ["stick", "slip"]}, "pebble": {"$ref": "#/$defs/vector"},
        "velocity": {"$ref": "#/$defs/vector"}, "normal": {"$ref": "#/$defs/vector"},
        "static": {"$ref": "#/$defs/number"}, "dynamic": {"$ref": "#/$defs/number"},
        "max_force": {"anyOf": [{"$ref": "#/$defs/number"}, {"type": "null"}]}}}]},
    "entry_ask": {"type": "object", "required": ["ask", "from", "to"], "additionalProperties": false, "properties": {
      "id": {"$ref": "#/$defs/id"}, "ask": {"const": "entry"}, "from": {"$ref": "#/$defs/vector"},
      "to": {"$ref": "#/$defs/vector"},
      "range": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 2, "maxItems": 2}}},
    "clip_ask": {"type": "object", "required": ["ask", "force", "normal", "friction", "brake"],
      "additionalProperties": false, "properties": {
      "id": {"$ref": "#/$defs/id"}, "ask": {"const": "clip"}, "force": {"$ref": "#/$defs/vector"},
      "normal": {"$ref": "#/$defs/vector"}, "friction": {"$ref": "#/$defs/number"},
      "brake": {"$ref": "#/$defs/number"}, "min_uprightness": {"$ref": "#/$defs/number"}}},
    "step_ask": {"type": "object", "required": ["ask", "wheel", "frame", "brake", "h", "state"],
      "additionalProperties": false, "properties": {
      "id": {"$ref": "#/$defs/id"}, "ask": {"const": "step"}, "wheel": {"type": "object"},
      "frame": {"type": "object", "properties": {"position": {"$ref": "#/$defs/vector"},
        "orientation": {"$ref": "#/$defs/quaternion"}, "velocity": {"$ref": "#/$defs/vector"},
        "angular_velocity": {"$ref": "#/$defs/vector"}}},
      "brake": {"$ref": "#/$defs/number"}, "h": {"$ref": "#/$defs/number"}, "state": {"$ref": "#/$defs/state"}}},
    "ask_line": {"anyOf": [
      {"type": "object", "required": ["scene"], "additionalProperties": false, "properties": {
        "scene": {"anyOf": [{"type": "string"}, {"$ref": "#/$defs/scene"}]}}},
      {"$ref": "#/$defs/entry_ask"}, {"$ref": "#/$defs/clip_ask"}, {"$ref": "#/$defs/step_ask"}]},
    "answer": {"anyOf": [
      {"type": "object", "required": ["kind"], "properties": {"kind": {"enum": ["miss", "too_steep"]}}},
      {"type": "object", "required": ["kind", "lambda"], "properties": {
        "kind": {"const": "inside"}, "lambda": {"$ref": "#/$defs/number"}}},
      {"type": "object", "required": ["kind", "lambda", "leaf", "normal", "material"], "properties": {
        "kind": {"const": "border"}, "lambda": {"$ref": "#/$defs/number"},
        "leaf": {"type": "integer", "minimum": 0}, "normal": {"$ref": "#/$defs/vector"},
        "material": {"type": ["string", "null"]}, "lambda_exact": {"type": "string"},
        "admissible": {"type": "array", "items": {"type": "integer", "minimum": 0}}}},
      {"type": "object", "required": ["kind", "force"], "properties": {
        "kind": {"enum": ["stick", "slip"]}, "force": {"$ref": "#/$defs/vector"}}},
      {"type": "object", "required": ["outcome", "state", "force"], "properties": {
        "outcome": {"const": "ok"}, "state": {"$ref": "#/$defs/state"}, "force": {"$ref": "#/$defs/vector"}}},
      {"type": "object", "required": ["outcome"], "properties": {
        "outcome": {"enum": ["wheel_broken", "surface_too_steep", "surface_gave_way"]}}}]},
    "answer_line": {"type": "object", "required": ["id"], "additionalProperties": false, "properties": {
      "id": {"$ref": "#/$defs/id"}, "answer": {"$ref": "#/$defs/answer"}, "error": {"type": "string"}},
      "oneOf": [{"required": ["answer"]}, {"required": ["error"]}]}
  },
  "anyOf": [{"$ref": "#/$defs/ask_line"}, {"$ref": "#/$defs/answer_line"}]
}
)";

}  // namespace groundtruth::report
