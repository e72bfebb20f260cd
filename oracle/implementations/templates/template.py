#!/usr/bin/env python3
"""Answers entry asks, in doubles. Copy it and put your own implementation in place of answer().

A line comes in, a line goes out, and is flushed: hello, then scenes and asks. Not done here: clip, step, paint,
and starts on a face that is left, which count as inside."""
import json
import sys
from math import inf


def spans(shape, start, along, leaves, material=None):
    """Where the line start + lambda * along runs in the shape: (first lambda, last lambda, leaf entered)."""
    if shape == "everything":
        return [(-inf, inf, None)]
    if shape == "nothing":
        return []
    if "halfspace" in shape:
        *normal, offset = shape["halfspace"]
        leaves.append({"leaf": len(leaves), "normal": normal, "material": material})
        distance = sum(n * x for n, x in zip(normal, start)) - offset
        slope = sum(n * x for n, x in zip(normal, along))
        if slope == 0:
            return [(-inf, inf, None)] if distance <= 0 else []
        crossing = -distance / slope
        return [(crossing, inf, leaves[-1])] if slope < 0 else [(-inf, crossing, None)]
    if "shape" in shape:
        return spans(shape["shape"], start, along, leaves, material or shape.get("material"))
    if "intersection" in shape:
        common = [(-inf, inf, None)]
        for part in shape["intersection"]:
            others = spans(part, start, along, leaves, material)
            pairs = [(max(a, b, key=lambda span: span[0]), min(a[1], b[1])) for a in common for b in others]
            common = [(late[0], last, late[2]) for late, last in pairs if late[0] <= last]
        return common
    merged = []
    found = [span for part in shape["union"] for span in spans(part, start, along, leaves, material)]
    for first, last, leaf in sorted(found, key=lambda span: span[0]):
        if merged and first <= merged[-1][1]:
            first, before, leaf = merged.pop()
            last = max(last, before)
        merged.append((first, last, leaf))
    return merged


def answer(shape, ask):
    near, far = ask["range"]
    along = [b - a for a, b in zip(ask["from"], ask["to"])]
    for first, last, leaf in spans(shape, ask["from"], along, []):
        if last >= near and first <= far:
            return {"kind": "border", "lambda": first, **leaf} if first >= near else {"kind": "inside", "lambda": near}
    return {"kind": "miss"}


for line in map(json.loads, sys.stdin):
    if "hello" in line:
        print(json.dumps({"hello": "answers/1", "name": "template.py", "asks": ["entry"]}), flush=True)
    elif "scene" in line:
        scene = line["scene"]
    else:
        print(json.dumps({"id": line["id"], "answer": answer(scene["shape"], line)}), flush=True)
