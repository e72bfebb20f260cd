(* Asks read, put to the proved computation, and its replies written. *)

type ask = { first_point : Proved.vector; last_point : Proved.vector; first : Proved.q; last : Proved.q }

let point place value =
  match Json.doubles place 3 value with [ x; y; z ] -> Scene.vector x y z | _ -> assert false

let range = function
  | None -> (0., 1.)
  | Some value -> (
    match Json.doubles "range" 2 value with
    | [ first; last ] when first <= last -> (first, last)
    | _ -> Json.bad "range: it ends before it begins")

let read_ask value =
  let kind = match value with `Assoc members -> List.assoc_opt "ask" members | _ -> None in
  (match kind with
   | Some (`String "entry") -> ()
   | Some (`String ("clip" | "step")) -> Json.bad "only entry asks are answered"
   | _ -> Json.bad "\"ask\": no known kind of ask");
  let members = Json.members "ask" [ "id"; "ask"; "from"; "to"; "range" ] value in
  let first, last = range (List.assoc_opt "range" members) in
  { first_point = point "from" (Json.member "ask" "from" members);
    last_point = point "to" (Json.member "ask" "to" members);
    first = Numbers.rational_of_double first;
    last = Numbers.rational_of_double last }

let quoted text = Yojson.Safe.to_string (`String text)
let list write values = "[" ^ String.concat "," (List.map write values) ^ "]"

let lambda place =
  Printf.sprintf "\"lambda\": %s, \"lambda_exact\": %s"
    (Numbers.text_of_double (Numbers.nearest_double place))
    (quoted (Numbers.text_of_rational place))

let border (scene : Scene.t) ask place (canonical : Proved.half_space) admissible =
  let numbers = List.sort_uniq compare (List.map (fun (leaf : Proved.half_space) -> leaf.number) admissible) in
  let here = Proved.point ask.first_point ask.last_point place in
  let material = match Scene.material scene canonical.number here with Some name -> quoted name | None -> "null" in
  Printf.sprintf {|{"kind": "border", %s, "leaf": %d, "normal": %s, "material": %s, "admissible": %s}|} (lambda place)
    canonical.number
    (list Numbers.text_of_double scene.leaves.(canonical.number).normal)
    material (list string_of_int numbers)

let text (scene : Scene.t) ask =
  match Proved.reply_to scene.solid ask.first_point ask.last_point ask.first ask.last with
  | Misses -> {|{"kind": "miss"}|}
  | Inside place -> Printf.sprintf {|{"kind": "inside", %s}|} (lambda place)
  | Border (place, canonical, admissible) -> border scene ask place canonical admissible
