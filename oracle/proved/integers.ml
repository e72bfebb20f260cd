(* Zarith's integers in the shapes that extraction.v names. Trusted to be Coq's Z and positive. *)

include Z

let match_positive odd even one n =
  if Z.equal n Z.one then one ()
  else if Z.is_odd n then odd (Z.shift_right n 1)
  else even (Z.shift_right n 1)

let match_integer zero positive negative n =
  match Z.sign n with 0 -> zero () | s when s > 0 -> positive n | _ -> negative (Z.neg n)

let compared less equal greater a b =
  match Z.compare a b with 0 -> equal | s when s < 0 -> less | _ -> greater

(* Of a and b, the greatest common divisor and what it leaves of each. *)
let cofactors a b =
  let divisor = Z.gcd a b in
  if Z.equal divisor Z.zero then (divisor, (Z.zero, Z.zero)) else (divisor, (Z.divexact a divisor, Z.divexact b divisor))
