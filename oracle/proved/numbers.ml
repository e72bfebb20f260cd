(* Between the doubles of the wire and the rationals of the proof. *)

let rational_of_double double : Proved.q =
  let exact = Q.of_float double in
  { qnum = Q.num exact; qden = Q.den exact }

(* To nearest, ties to even, down to the subnormals. *)
let nearest_double (value : Proved.q) = Q.to_float (Q.make value.qnum value.qden) +. 0.

(* In lowest terms; "1" for 1. *)
let text_of_rational (value : Proved.q) = Q.to_string (Q.make value.qnum value.qden)

(* The shortest decimal that reads back to the same double. *)
let text_of_double double =
  let rec with_digits digits =
    let text = Printf.sprintf "%.*g" digits double in
    if digits >= 17 || float_of_string text = double then text else with_digits (digits + 1)
  in
  if double = 0. then "0" else with_digits 1
