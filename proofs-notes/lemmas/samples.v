(* One rational in each gap between finitely many, and one direction off finitely many planes: computed. *)

From Coq Require Import List Bool QArith Qabs Lqa.
From Groundtruth Require Import shapes standing local_shape.
Import ListNotations.
Open Scope Q_scope.

Fixpoint least (roots : list Q) : option Q :=
  match roots with
  | [] => None
  | r :: rest => match least rest with Some s => Some (if Qlt_le_dec r s then r else s) | None => Some r end
  end.

Definition beyond (r : Q) (roots : list Q) : list Q := filter (fun s => negb (Qle_bool s r)) roots.
Definition after (roots : list Q) (r : Q) : Q :=
  match least (beyond r roots) with Some s => (r + s) / 2 | None => r + 1 end.
Definition distinct (roots : list Q) : list Q :=
  fold_right (fun r rest => if existsb (Qeq_bool r) rest then rest else r :: rest) [] roots.
Definition samples_between (roots : list Q) : list Q :=
  (match least roots with Some r => r - 1 | None => 0 end) :: map (after roots) roots.
Definition samples (roots : list Q) : list Q := samples_between (distinct roots).

Lemma least_is_least roots : match least roots with
  | Some r => In r roots /\ forall s, In s roots -> r <= s
  | None => roots = []
  end.
Proof.
  induction roots as [| r rest IH]; simpl; trivial. destruct (least rest) as [s |].
  - destruct IH as (inside & below). destruct (Qlt_le_dec r s).
    + split; [now left |]. intros w [<- | there]; [lra | specialize (below w there); lra].
    + split; [now right |]. intros w [<- | there]; [lra | auto].
  - subst. split; [now left |]. intros w [<- | []]. lra.
Qed.

Lemma is_beyond r roots s : In s (beyond r roots) <-> In s roots /\ r < s.
Proof.
  unfold beyond. rewrite filter_In, negb_true_iff, <- not_true_iff_false, Qle_bool_iff.
  split; intros (inside & more); split; trivial; lra.
Qed.

Lemma after_is_next roots r : r < after roots r /\ forall s, In s roots -> r < s -> after roots r < s.
Proof.
  unfold after. assert (found := least_is_least (beyond r roots)). destruct (least _) as [next |].
  - destruct found as (inside & below). apply is_beyond in inside as (_ & more).
    assert (middle : (r + next) / 2 * 2 == r + next) by field. split; [lra |].
    intros s there above. assert (next <= s) by (apply below, is_beyond; now split). lra.
  - split; [lra |]. intros s there above. assert (inside : In s (beyond r roots)) by (apply is_beyond; now split).
    rewrite found in inside. easy.
Qed.

Lemma greatest_before roots t : (exists r, In r roots /\ r < t) ->
  exists r, In r roots /\ r < t /\ forall s, In s roots -> s < t -> s <= r.
Proof.
  induction roots as [| q rest IH]; intros (r & inside & less); [easy |].
  destruct (Qlt_le_dec q t) as [before | past].
  - destruct (existsb (fun s => negb (Qle_bool t s)) rest) eqn:others.
    + apply existsb_exists in others as (s & there & before_s).
      rewrite negb_true_iff, <- not_true_iff_false, Qle_bool_iff in before_s.
      destruct IH as (g & in_rest & g_less & greatest); [exists s; split; trivial; lra |].
      destruct (Qlt_le_dec g q).
      * exists q. split; [now left |]. split; trivial. intros w [<- | b] w_less; [lra |].
        specialize (greatest w b w_less). lra.
      * exists g. split; [now right |]. split; trivial. intros w [<- | b] w_less; auto.
    + exists q. split; [now left |]. split; trivial. intros w [<- | b] w_less; [lra |]. exfalso.
      apply not_true_iff_false in others. apply others, existsb_exists. exists w. split; trivial.
      rewrite negb_true_iff, <- not_true_iff_false, Qle_bool_iff. lra.
  - destruct IH as (g & in_rest & g_less & greatest).
    { destruct inside as [-> | inside]; [lra | now exists r]. }
    exists g. split; [now right |]. split; trivial. intros w [<- | b] w_less; [lra | auto].
Qed.

Lemma any_before roots t : {exists r, In r roots /\ r < t} + {forall r, In r roots -> t <= r}.
Proof.
  induction roots as [| q rest IH]; [now right |]. destruct (Qlt_le_dec q t).
  - left. exists q. split; [now left | trivial].
  - destruct IH as [some | none].
    + left. destruct some as (r & inside & less). exists r. split; [now right | trivial].
    + right. intros r [<- | inside]; auto.
Qed.

Lemma distinct_are_the_same roots :
  (forall r, In r roots -> exists s, In s (distinct roots) /\ r == s) /\ (forall s, In s (distinct roots) -> In s roots).
Proof.
  induction roots as [| q rest (covered & inside)]; simpl; [split; easy |].
  destruct (existsb (Qeq_bool q) (distinct rest)) eqn:known.
  - split; [| intros s there; right; now apply inside]. intros r [<- | there]; [| now apply covered].
    apply existsb_exists in known as (s & there & same). exists s. split; trivial. now apply Qeq_bool_iff.
  - split.
    + intros r [<- | there]; [exists q; split; [now left | reflexivity] |].
      destruct (covered r there) as (s & found & same). exists s. split; [now right | trivial].
    + intros s [<- | there]; [now left | right; now apply inside].
Qed.

Lemma samples_are_between roots t : (forall r, In r roots -> ~ t == r) ->
  exists c, In c (samples_between roots) /\ forall r, In r roots -> (t < r -> c < r) /\ (r < t -> r < c).
Proof.
  intros off. destruct (any_before roots t) as [some | none].
  - destruct (greatest_before roots t some) as (low & inside & less & greatest).
    destruct (after_is_next roots low) as (above & next).
    exists (after roots low). split; [right; now apply in_map |]. intros r there. split; intros order.
    + apply next; trivial. lra.
    + specialize (greatest r there order). lra.
  - eexists. split; [now left |]. intros r there. assert (found := least_is_least roots).
    assert (t_r := none r there). destruct (least roots) as [low |]; [| now subst].
    assert (low <= r) by now apply found. split; intros; lra.
Qed.

(* A sample lies in the gap of t. *)
Theorem samples_are_in_every_gap roots t : (forall r, In r roots -> ~ t == r) ->
  exists c, In c (samples roots) /\ forall r, In r roots -> (t < r -> c < r) /\ (r < t -> r < c).
Proof.
  intros off. destruct (distinct_are_the_same roots) as (covered & inside).
  destruct (samples_are_between (distinct roots) t) as (c & found & gap); [intros r there; apply off, inside, there |].
  exists c. split; [exact found |]. intros r there. destruct (covered r there) as (s & known & same).
  destruct (gap s known) as (up & down). split; intros order.
  - assert (c < s) by (apply up; lra). lra.
  - assert (s < c) by (apply down; lra). lra.
Qed.

(* (1, t, t^2) lies in no plane of finitely many, if t is large enough. *)
Definition curve (t : Q) : vector := Vector 1 t (t * t).
Definition enough (n : vector) : Q :=
  if Qeq_bool (z n) 0 then Qabs (x n) * Qabs (/ y n) else (Qabs (x n) + Qabs (y n)) * Qabs (/ z n).
Definition generic (normals : list vector) : vector := curve (fold_right (fun n t => enough n + t) 2 normals).

Lemma abs_of_product a b : Qabs (a * b) == Qabs a * Qabs b.
Proof. apply Qabs_Qmult. Qed.

Lemma far_enough n t : ~ (x n == 0 /\ y n == 0 /\ z n == 0) -> 1 < t -> enough n < t -> ~ dot n (curve t) == 0.
Proof.
  intros normal_ one far zero. unfold dot, curve in zero. cbn [local_shape.x local_shape.y local_shape.z] in zero.
  assert (inverse : forall a, ~ a == 0 -> Qabs a * Qabs (/ a) == 1).
  { intros a nonzero. rewrite <- abs_of_product, Qmult_inv_r by assumption. reflexivity. }
  assert (positive : forall a, ~ a == 0 -> 0 < Qabs a).
  { intros a nonzero. destruct (Qlt_le_dec 0 (Qabs a)); trivial. exfalso. apply nonzero.
    assert (high := Qle_Qabs a). assert (low := Qle_Qabs (- a)). rewrite Qabs_opp in low. lra. }
  assert (px := Qabs_nonneg (x n)). assert (py := Qabs_nonneg (y n)). assert (pz := Qabs_nonneg (z n)).
  unfold enough in far. destruct (Qeq_bool (z n) 0) eqn:flat.
  - apply Qeq_bool_iff in flat. destruct (Qeq_dec (y n) 0) as [level | tilted].
    + apply normal_. split; [| now split]. rewrite level, flat in zero. lra.
    + assert (sum : x n == - (y n * t)) by (rewrite flat in zero; lra).
      assert (same : Qabs (x n) == Qabs (y n) * t)
        by (rewrite sum, Qabs_opp, abs_of_product, (Qabs_pos t) by lra; reflexivity).
      assert (i := inverse _ tilted). rewrite same in far. nra.
  - apply Qeq_bool_neq in flat. assert (i := inverse _ flat). assert (p := positive _ flat).
    assert (same : Qabs (z n) * (t * t) <= Qabs (x n) + Qabs (y n) * t).
    { assert (sum : z n * (t * t) == - (x n + y n * t)) by lra.
      assert (e : Qabs (z n * (t * t)) == Qabs (x n + y n * t)) by (rewrite sum; apply Qabs_opp).
      rewrite abs_of_product, (Qabs_pos (t * t)) in e by nra.
      assert (tri := Qabs_triangle (x n) (y n * t)). rewrite (abs_of_product (y n)), (Qabs_pos t) in tri by lra. lra. }
    assert (room : Qabs (x n) + Qabs (y n) < Qabs (z n) * t).
    { assert (e : Qabs (z n) * ((Qabs (x n) + Qabs (y n)) * Qabs (/ z n)) == Qabs (x n) + Qabs (y n))
        by (transitivity ((Qabs (x n) + Qabs (y n)) * (Qabs (z n) * Qabs (/ z n))); [ring | rewrite i; ring]).
      assert (times := proj2 (Qmult_lt_l _ _ _ p) far). lra. }
    nra.
Qed.

Lemma enough_is_not_negative n : 0 <= enough n.
Proof.
  unfold enough. destruct (Qeq_bool _ _).
  - assert (a := Qabs_nonneg (x n)). assert (b := Qabs_nonneg (/ y n)). nra.
  - assert (a := Qabs_nonneg (x n)). assert (b := Qabs_nonneg (y n)). assert (c := Qabs_nonneg (/ z n)). nra.
Qed.

Theorem generic_is_in_no_plane normals n : In n normals -> ~ (x n == 0 /\ y n == 0 /\ z n == 0) ->
  ~ dot n (generic normals) == 0.
Proof.
  intros inside normal_. unfold generic. set (t := fold_right _ _ _).
  assert (bound : 2 <= fold_right (fun n t => enough n + t) 2 normals
                  /\ forall m, In m normals -> enough m + 2 <= fold_right (fun n t => enough n + t) 2 normals).
  { clear. induction normals as [| m rest (two & IH)]; simpl; [split; [lra | easy] |].
    assert (a := enough_is_not_negative m). split; [lra |].
    intros k [<- | inside]; [lra | specialize (IH k inside); lra]. }
  fold t in bound. destruct bound as (two & each). specialize (each n inside). apply far_enough; trivial; lra.
Qed.

Print Assumptions samples_are_in_every_gap.
Print Assumptions generic_is_in_no_plane.
