(* Scenes read into the shapes of the proof. *)

type solid = Proved.half_space Proved.shape

(* What gives a leaf its material: a name, and where it is painted. *)
type coat = { material : string; where : solid }
type leaf = { normal : float list; coats : coat list (* outermost first *) }
type t = { solid : solid; leaves : leaf array }

let everything : solid = Intersection []
let nothing : solid = Union []

type reading = { materials : string list; mutable found : leaf list; mutable count : int }

let vector x y z : Proved.vector =
  { x = Numbers.rational_of_double x; y = Numbers.rational_of_double y; z0 = Numbers.rational_of_double z }

let half_space reading coats (x, y, z, offset) : solid =
  let number = reading.count in
  reading.count <- number + 1;
  reading.found <- { normal = [ x; y; z ]; coats = List.rev coats } :: reading.found;
  Leaf { number; normal = vector x y z; offset = Numbers.rational_of_double offset }

let box reading coats place value : solid =
  match List.map (Json.doubles place 3) (Json.array place value) with
  | [ [ a; b; c ]; [ d; e; f ] ] ->
    let sides =
      [ (-1., 0., 0., -.a); (1., 0., 0., d); (0., -1., 0., -.b); (0., 1., 0., e); (0., 0., -1., -.c); (0., 0., 1., f) ] in
    Intersection (List.map (half_space reading coats) sides)
  | _ -> Json.bad "%s: two corners are needed" place

let known_material reading place value =
  let name = Json.text place value in
  if List.mem name reading.materials then name else Json.bad "%s: no material is called \"%s\"" place name

(* `coats`: innermost first. *)
let rec shape reading coats value : solid =
  let operands place value = List.map (shape reading coats) (Json.array place value) in
  match value with
  | `String "everything" -> everything
  | `String "nothing" -> nothing
  | `Assoc [ ("union", value) ] -> Union (operands "union" value)
  | `Assoc [ ("intersection", value) ] -> Intersection (operands "intersection" value)
  | `Assoc [ ("box", value) ] -> box reading coats "box" value
  | `Assoc [ ("halfspace", value) ] -> (
    match Json.doubles "halfspace" 4 value with
    | [ x; y; z; offset ] -> half_space reading coats (x, y, z, offset)
    | _ -> assert false)
  | `Assoc members when List.mem_assoc "material" members ->
    let members = Json.members "material" [ "material"; "shape" ] value in
    let material = known_material reading "material" (Json.member "material" "material" members) in
    shape reading ({ material; where = everything } :: coats) (Json.member "material" "shape" members)
  | `Assoc members when List.mem_assoc "paint" members ->
    let members = Json.members "paint" [ "paint"; "where"; "shape" ] value in
    let material = known_material reading "paint" (Json.member "paint" "paint" members) in
    let where = region reading (Json.member "paint" "where" members) in
    shape reading ({ material; where } :: coats) (Json.member "paint" "shape" members)
  | _ -> Json.bad "a shape is needed: halfspace, box, union, intersection, material, paint, everything or nothing"

(* Its half-spaces are no leaves of the solid. *)
and region reading value = shape { reading with found = []; count = 0 } [] value

let check_friction (_, value) =
  let members = Json.members "friction" [ "static"; "dynamic" ] value in
  List.iter
    (fun key ->
      if Json.double key (Json.member "friction" key members) < 0. then Json.bad "friction: \"%s\" is negative" key)
    [ "static"; "dynamic" ]

let check_material (_, value) =
  let members = Json.members "material" [ "friction"; "max_force" ] value in
  List.iter check_friction (Json.members "friction" [] (Json.member "material" "friction" members));
  match List.assoc_opt "max_force" members with
  | None | Some `Null -> ()
  | Some value -> if Json.double "max_force" value < 0. then Json.bad "max_force is negative"

let read value =
  let members = Json.members "scene" [ "groundtruth"; "materials"; "shape" ] value in
  if Json.member "scene" "groundtruth" members <> `String "scene/1" then Json.bad "scene: no scene/1";
  let materials =
    match List.assoc_opt "materials" members with None -> [] | Some value -> Json.members "materials" [] value in
  List.iter check_material materials;
  let reading = { materials = List.map fst materials; found = []; count = 0 } in
  let solid = shape reading [] (Json.member "scene" "shape" members) in
  { solid; leaves = Array.of_list (List.rev reading.found) }

(* The first coat from the outside that covers the point, decides. *)
let material scene number point =
  let covers coat = Proved.value (Proved.contains point) coat.where in
  Option.map (fun coat -> coat.material) (List.find_opt covers scene.leaves.(number).coats)
