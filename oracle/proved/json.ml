(* JSON values with the wire's rules for numbers and keys (SPEC section 8). *)

exception Bad of string

let bad format = Printf.ksprintf (fun problem -> raise (Bad problem)) format

let parse text =
  try Yojson.Safe.from_string text with Yojson.Json_error problem -> bad "no JSON: %s" (String.concat " " (String.split_on_char '\n' problem))

(* The members of an object, each key known and there at most once. *)
let members place known = function
  | `Assoc members ->
    let seen = Hashtbl.create 8 in
    List.iter
      (fun (key, _) ->
        if known <> [] && not (List.mem key known) then bad "%s: unknown key \"%s\"" place key;
        if Hashtbl.mem seen key then bad "%s: \"%s\" stands twice" place key;
        Hashtbl.add seen key ())
      members;
    members
  | _ -> bad "%s: an object is needed" place

let member place key members =
  match List.assoc_opt key members with Some value -> value | None -> bad "%s: \"%s\" is missing" place key

let finite place double = if Float.is_finite double then double else bad "%s: out of the range of doubles" place

let of_integer place text =
  let double = finite place (float_of_string text) in
  if Z.equal (Z.of_float double) (Z.of_string text) then double else bad "%s: no double equals %s" place text

let is_hex_float text =
  let digits = if String.length text > 0 && text.[0] = '-' then String.sub text 1 (String.length text - 1) else text in
  String.length digits > 2 && String.sub digits 0 2 = "0x" && not (String.contains digits '_')

let double place = function
  | `Float value -> finite place value
  | `Int value -> of_integer place (string_of_int value)
  | `Intlit text -> of_integer place text
  | `String text when is_hex_float text -> (
    match float_of_string_opt text with Some value -> finite place value | None -> bad "%s: no number: %s" place text)
  | _ -> bad "%s: a number is needed" place

let text place = function `String text -> text | _ -> bad "%s: a string is needed" place
let array place = function `List values -> values | _ -> bad "%s: an array is needed" place

let doubles place count value =
  let values = List.map (double place) (array place value) in
  if List.length values = count then values else bad "%s: %d numbers are needed" place count
