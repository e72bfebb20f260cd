(* proved-phi: entry asks answered by what was extracted from Coq, over the pipe of SPEC section 8. Only what is in
   this folder, reading and writing, is unproved. *)

type state = { mutable scene : Scene.t option; mutable scene_line : string }

let error id problem = Printf.sprintf {|{"id": %s, "error": %s}|} id (Answer.quoted problem)

let read_file name =
  let channel = try open_in_bin name with Sys_error problem -> Json.bad "%s" problem in
  Fun.protect ~finally:(fun () -> close_in channel) (fun () -> really_input_string channel (in_channel_length channel))

let use_scene state line value =
  state.scene <- None;
  state.scene_line <- "";
  let scene = match value with `String file -> Json.parse (read_file file) | value -> value in
  state.scene <- Some (Scene.read scene);
  state.scene_line <- line

let id_of members =
  match List.assoc_opt "id" members with
  | Some (`String _ | `Int _ | `Intlit _ | `Float _ as id) -> Yojson.Safe.to_string id
  | _ -> "null"

let hello =
  {|{"hello": "answers/1", "name": "proved-phi (extracted from Coq)", "asks": ["entry"]}|}

let answer state value members =
  let id = id_of members in
  try
    let ask = Answer.read_ask value in
    match state.scene with
    | None -> error id "no scene: the ask needs one, and none has been read"
    | Some scene -> Printf.sprintf {|{"id": %s, "answer": %s}|} id (Answer.text scene ask)
  with Json.Bad problem -> error id problem

let respond state line =
  try
    match Json.parse line with
    | `Assoc [ ("hello", `String "answers/1") ] -> Some hello
    | `Assoc [ ("scene", value) ] -> use_scene state line value; None
    | `Assoc members as value -> Some (answer state value members)
    | _ -> Some (error "null" "a line is one JSON object")
  with Json.Bad problem -> Some (error "null" problem)

(* A scene that was just read is not read again. *)
let () =
  let state = { scene = None; scene_line = "" } in
  try
    while true do
      let line = input_line stdin in
      if line <> state.scene_line || line = "" then
        Option.iter (fun text -> print_string text; print_newline ()) (respond state line)
    done
  with End_of_file -> ()
