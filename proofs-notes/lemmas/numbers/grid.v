(* Lemma grid-squares (proofs-notes/rounding.md): a part whose box holds a point of the range is among the entries that are
   visited. fast/grid.hpp and fast/grid.cpp, which lay parts out; fast/grid_probe.hpp, which asks for them. Doubles are
   without a largest one; numbers that are turned into whole ones are between limits first. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core Relative.
From Groundtruth Require Import doubles range_ends.
Open Scope R_scope.

(* static_cast<uint32_t> of what lies between 0 and the last one. *)
Definition whole place last := Zfloor (Rmin (Rmax place 0) (IZR last)).

Lemma whole_is_monotone : forall p q last, p <= q -> (whole p last <= whole q last)%Z.
Proof. intros. apply Zfloor_le, Rle_min_compat_r, Rle_max_compat_r. assumption. Qed.

(* As Grid::whole has it, by comparisons. *)
Lemma whole_by_comparisons : forall p last, (0 <= last)%Z ->
  whole p last = if Rle_dec p 0 then 0%Z else if Rlt_dec p (IZR last) then Zfloor p else last.
Proof.
  intros p last some. unfold whole. assert (0 <= IZR last) by now apply IZR_le.
  destruct (Rle_dec p 0); [rewrite Rmax_right, Rmin_left by lra; apply Zfloor_IZR |]. rewrite Rmax_left by lra.
  destruct (Rlt_dec p (IZR last)); [now rewrite Rmin_left by lra | rewrite Rmin_right by lra; apply Zfloor_IZR].
Qed.

Section Axis.

(* Squares over one axis. *)
Variables origin per_metre : R.
Hypothesis per_metre_pos : 0 <= per_metre.
Variable count : Z.

Definition place x := fl (fl (x - origin) * per_metre).
Definition square_of x := whole (place x) (count - 1).
Definition part_of_square x square := whole (fl (fl (place x - IZR square) * 512)) 511.
Definition part_of_height x := whole (place x) 511.

Lemma place_is_monotone : forall x y, x <= y -> place x <= place y.
Proof. intros. apply fl_monotone, Rmult_le_compat_r; [assumption |]. apply fl_monotone. lra. Qed.

Lemma part_is_monotone : forall x y square, x <= y -> (part_of_square x square <= part_of_square y square)%Z.
Proof.
  intros x y square le. apply whole_is_monotone, fl_monotone, Rmult_le_compat_r; [lra |]. apply fl_monotone.
  pose proof (place_is_monotone x y le). lra.
Qed.

Lemma height_is_monotone : forall x y, x <= y -> (part_of_height x <= part_of_height y)%Z.
Proof. intros. now apply whole_is_monotone, place_is_monotone. Qed.

(* Two stretches that overlap have a square in common, and overlap there. *)
Lemma stretches_share_a_square : forall first last low high, first <= last -> low <= high -> first <= high -> low <= last ->
  exists square, (square_of first <= square <= square_of last /\ square_of low <= square <= square_of high
    /\ part_of_square low square <= part_of_square last square /\ part_of_square first square <= part_of_square high square)%Z.
Proof.
  intros first last low high ordered box_ordered one other. exists (Z.max (square_of first) (square_of low)).
  assert (forall x y, x <= y -> (square_of x <= square_of y)%Z) as monotone by (intros; unfold square_of; apply whole_is_monotone; now apply place_is_monotone).
  pose proof (monotone _ _ ordered). pose proof (monotone _ _ box_ordered). pose proof (monotone _ _ one). pose proof (monotone _ _ other).
  repeat split; try lia; now apply part_is_monotone.
Qed.

End Axis.

(* An end as computed, x, and exact, X: its margin of 2 e covers it. *)
Definition covers x X e := fl (x - 2 * e) <= X <= fl (x + 2 * e).

Lemma exact_end_is_covered : forall x e, is_double x -> 0 <= e -> covers x x e.
Proof. intros x e Dx pos. unfold covers. rewrite <- (fl_of_double x Dx) at 2 3. split; apply fl_monotone; lra. Qed.

Lemma near_end_is_covered : forall x X e, is_double x -> is_double (2 * e) -> Rabs (x - X) <= e -> 2 * u * Rabs x <= e -> covers x X e.
Proof.
  intros x X e Dx De near enough. pose proof (Rabs_pos (x - X)). apply within in near. assert (is_double (- (2 * e))) by now apply generic_format_opp.
  pose proof (sum_error x (2 * e) Dx De) as above. pose proof (sum_error x (- (2 * e)) Dx ltac:(assumption)) as below.
  pose proof (magnitude x).
  assert (u * Rabs (x + 2 * e) <= u * (Rabs x + 2 * e)) by (apply Rmult_le_compat_l; [unfold u; lra | apply Rabs_le; lra]).
  assert (u * Rabs (x + - (2 * e)) <= u * (Rabs x + 2 * e)) by (apply Rmult_le_compat_l; [unfold u; lra | apply Rabs_le; lra]).
  apply within in above. apply within in below. unfold covers, Rminus. unfold u in *; lra.
Qed.

(* What range_ends.hpp makes; the error is the largest of the coordinates. *)
Lemma placed_end_is_covered : forall from to lambda e, is_double from -> is_double to -> is_double (2 * e) ->
  coordinate_error from to lambda <= e -> covers (placed from to lambda) (from + lambda * (to - from)) e.
Proof.
  intros from to lambda e Dfrom Dto De enough. apply near_end_is_covered; [apply fl_is_double | assumption | |].
  - apply Rle_trans with (2 := enough). now apply ends_are_near.
  - apply Rle_trans with (2 := enough). now apply error_exceeds_roundings.
Qed.

(* An end that is rounded correctly (fast/exact_stage/strut.cpp). *)
Lemma rounded_end_is_covered : forall X e, is_double (2 * e) -> 0 < e -> u * Rabs (fl X) <= e -> covers (fl X) X e.
Proof.
  intros X e De pos enough. assert (is_double (- (2 * e))) by now apply generic_format_opp. unfold covers.
  pose proof (sum_error (fl X) (2 * e) (fl_is_double _) De) as above.
  pose proof (sum_error (fl X) (- (2 * e)) (fl_is_double _) ltac:(assumption)) as below. change (fl X + - (2 * e)) with (fl X - 2 * e) in below.
  pose proof (magnitude (fl X)).
  assert (u * Rabs (fl X + 2 * e) <= u * (Rabs (fl X) + 2 * e)) by (apply Rmult_le_compat_l; [unfold u; lra | apply Rabs_le; lra]).
  assert (u * Rabs (fl X - 2 * e) <= u * (Rabs (fl X) + 2 * e)) by (apply Rmult_le_compat_l; [unfold u; lra | apply Rabs_le; lra]).
  split; apply Rnot_lt_le; intros beyond; apply Rlt_le in beyond; apply fl_monotone in beyond;
    rewrite (fl_of_double (fl _)) in beyond by apply fl_is_double.
  - apply within in below. unfold u in *; lra.
  - apply within in above. unfold u in *; lra.
Qed.

(* A range's ends on an axis, F and T exact, and a point of it. *)
Section Range.

Variables f t F T e s : R.
Hypotheses (first_covered : covers f F e) (last_covered : covers t T e) (s_in_range : 0 <= s <= 1).
Let P := F + s * (T - F).
Definition least := fl (Rmin f t - 2 * e).
Definition greatest := fl (Rmax f t + 2 * e).

Lemma point_is_between : least <= P <= greatest.
Proof.
  destruct first_covered as (f_low & f_high). destruct last_covered as (t_low & t_high).
  assert (least <= fl (f - 2 * e)) by (apply fl_monotone; pose proof (Rmin_l f t); lra).
  assert (least <= fl (t - 2 * e)) by (apply fl_monotone; pose proof (Rmin_r f t); lra).
  assert (fl (f + 2 * e) <= greatest) by (apply fl_monotone; pose proof (Rmax_l f t); lra).
  assert (fl (t + 2 * e) <= greatest) by (apply fl_monotone; pose proof (Rmax_r f t); lra).
  assert (P = (1 - s) * F + s * T) as -> by (unfold P; ring).
  assert ((1 - s) * least <= (1 - s) * F <= (1 - s) * greatest) by (split; apply Rmult_le_compat_l; lra).
  assert (s * least <= s * T <= s * greatest) by (split; apply Rmult_le_compat_l; lra). lra.
Qed.

End Range.

Section Entries.

(* Axes across, along and upward: the range's ends; what they are exactly; where the part's box is. *)
Variables fa ta Fa Ta fl_ tl Fl Tl fu tu Fu Tu e s : R.
Hypotheses (a_first : covers fa Fa e) (a_last : covers ta Ta e) (l_first : covers fl_ Fl e) (l_last : covers tl Tl e).
Hypotheses (u_first : covers fu Fu e) (u_last : covers tu Tu e) (s_in_range : 0 <= s <= 1).
Variables low_a high_a low_l high_l low_u high_u : R.
Hypothesis in_box : low_a <= Fa + s * (Ta - Fa) <= high_a /\ low_l <= Fl + s * (Tl - Fl) <= high_l /\ low_u <= Fu + s * (Tu - Fu) <= high_u.
Variables origin_a origin_l origin_u per_metre upward_per_metre : R.
Hypotheses (per_metre_pos : 0 <= per_metre) (upward_pos : 0 <= upward_per_metre).
Variables columns rows : Z.

Let column x := square_of origin_a per_metre columns x.
Let row x := square_of origin_l per_metre rows x.
Let across x c := part_of_square origin_a per_metre x c.
Let along x r := part_of_square origin_l per_metre x r.
Let upward x := part_of_height origin_u upward_per_metre x.

(* The part has an entry in a square that is looked at (squares()), and its six places compare so that Stretches::reach() lets it pass. *)
Theorem met_part_is_visited : exists c r : Z,
  (column (least fa ta e) <= c <= column (greatest fa ta e) /\ row (least fl_ tl e) <= r <= row (greatest fl_ tl e))%Z /\
  (column low_a <= c <= column high_a /\ row low_l <= r <= row high_l)%Z /\
  (across low_a c <= across (greatest fa ta e) c /\ across (least fa ta e) c <= across high_a c)%Z /\
  (along low_l r <= along (greatest fl_ tl e) r /\ along (least fl_ tl e) r <= along high_l r)%Z /\
  (upward low_u <= upward (greatest fu tu e) /\ upward (least fu tu e) <= upward high_u)%Z.
Proof.
  destruct in_box as (box_a & box_l & box_u).
  pose proof (point_is_between fa ta Fa Ta e s a_first a_last s_in_range).
  pose proof (point_is_between fl_ tl Fl Tl e s l_first l_last s_in_range).
  pose proof (point_is_between fu tu Fu Tu e s u_first u_last s_in_range).
  destruct (stretches_share_a_square origin_a per_metre per_metre_pos columns (least fa ta e) (greatest fa ta e) low_a high_a) as (c & Hc); try lra.
  destruct (stretches_share_a_square origin_l per_metre per_metre_pos rows (least fl_ tl e) (greatest fl_ tl e) low_l high_l) as (r & Hr); try lra.
  exists c, r. unfold column, row, across, along, upward. repeat split; try tauto; apply height_is_monotone; try assumption; lra.
Qed.

End Entries.

Print Assumptions whole_by_comparisons.
Print Assumptions placed_end_is_covered.
Print Assumptions rounded_end_is_covered.
Print Assumptions met_part_is_visited.
