(* The proved answer in OCaml, for oracle/proved (entry-point.md, 7). Trusted here, beside Coq's extraction: that
   Zarith's integers are Coq's, and that leaf numbers and counts of leaves fit OCaml's 63 bits. *)

From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ZArith QArith.
From Groundtruth Require Import shapes local_shape proved_phi.

Extract Inductive positive => "Integers.t"
  ["(fun p -> Integers.succ (Integers.shift_left p 1))" "(fun p -> Integers.shift_left p 1)" "Integers.one"]
  "Integers.match_positive".
Extract Inductive Z => "Integers.t" ["Integers.zero" "" "Integers.neg"] "Integers.match_integer".
Extract Constant Pos.add => "Integers.add".
Extract Constant Pos.mul => "Integers.mul".
Extract Constant Pos.eq_dec => "Integers.equal".
Extract Constant Z.add => "Integers.add".
Extract Constant Z.mul => "Integers.mul".
Extract Constant Z.opp => "Integers.neg".
Extract Constant Z.compare => "Integers.compared Lt Eq Gt".
Extract Constant Z.leb => "Integers.leq".
Extract Constant Z.ltb => "Integers.lt".
Extract Constant Z.eqb => "Integers.equal".
Extract Constant Z.eq_dec => "Integers.equal".
Extract Constant Z.abs => "Integers.abs".
Extract Constant Z.ggcd => "Integers.cofactors".

Extraction "proved.ml" reply_to point local_shape.contains shapes.value.

Print Assumptions reply_to_is_right.
