(** Rounding errors of the 64-bit filters. That of a grid row (crates/core/src/stability/batch/row_filter.rs): where the value of a polynomial by Horner's scheme is
    larger than its computed bound, it has the sign of the polynomial. Rounding is any that errs by the unit roundoff and the underflow. *)

From Slipmode Require Export Tactics.

Definition unit_roundoff : R := / 2 ^ 53.
Definition underflow : R := / 2 ^ 1074.

(** The constants of the code. *)
Definition relative_bound : R := / 2 ^ 48.
Definition absolute_bound : R := / 2 ^ 1000.

Lemma underflow_small : 0 < underflow /\ 1000 * underflow <= absolute_bound.
Proof.
  unfold underflow, absolute_bound; assert (P : 0 < 2 ^ 1000) by (apply pow_lt; lra).
  replace 1074%nat with (1000 + 74)%nat by reflexivity; rewrite pow_add, Rinv_mult; set (t := 2 ^ 1000) in *.
  assert (T : 0 < / t) by now apply Rinv_0_lt_compat.
  assert (Q : 0 < / 2 ^ 74) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (S : 1000 * / 2 ^ 74 <= 1) by (simpl; lra).
  split; [now apply Rmult_lt_0_compat|]; nra.
Qed.

Section Filter.

Let u := unit_roundoff.
Let h := relative_bound.
Let eta := underflow.
Let tiny := absolute_bound.

Let u_value : u = / 9007199254740992.
Proof. unfold u, unit_roundoff; simpl; lra. Qed.

Let h_value : h = 32 * u.
Proof. unfold h, relative_bound, u, unit_roundoff; simpl; lra. Qed.

Let eta_pos : 0 <= eta.
Proof. left; apply underflow_small. Qed.

Let tiny_large : 1000 * eta <= tiny.
Proof. apply underflow_small. Qed.

(** Sums and products of 64-bit numbers: a sum does not underflow. *)
Variables add mul : R -> R -> R.
Hypotheses
  (add_error : forall x y, Rabs (add x y - (x + y)) <= unit_roundoff * Rabs (x + y))
  (mul_error : forall x y, Rabs (mul x y - x * y) <= unit_roundoff * Rabs (x * y) + underflow).

Let sum_error (x y : R) : Rabs (add x y - (x + y)) <= u * Rabs (x + y).
Proof. apply add_error. Qed.

Let product_error (x y : R) : Rabs (mul x y - x * y) <= u * Rabs (x * y) + eta.
Proof. apply mul_error. Qed.

(** A coefficient Q is known by a centre c and a radius r. In 64-bit they are v and rho, and d is the coefficient of the bound. *)
Let known (Q v r : R) : Prop := exists c, Rabs (c - Q) <= r /\ Rabs (v - c) <= u * Rabs c + eta.
Let bounds (v r d : R) : Prop := exists rho, Rabs (rho - r) <= eta /\ d = add (mul h (Rabs v)) rho.

(** After n steps: the computed value and bound, the exact value, the same with absolute values, and that of the radii. *)
Let after (n val bnd E A S : R) : Prop :=
  0 <= A /\ 0 <= S /\ Rabs val <= (1 + 3 * n * u) * (A + n * eta) /\
  Rabs (val - E) <= (3 * n + 2) * u * A + S + (5 * n + 2) * eta /\
  (1 - (2 * n + 2) * u) * (h * A + S) - (6 * n + 4) * eta <= bnd.

Let radius (Q v r : R) : known Q v r -> 0 <= r /\ Rabs (v - Q) <= 2 * u * Rabs v + r + 2 * eta.
Proof.
  intros (c & C & W); pose proof (Rabs_pos (c - Q)); split; [lra|].
  assert (Rabs c <= Rabs v + Rabs (v - c)).
  { replace c with (v - (v - c)) at 1 by ring; unfold Rminus at 1; eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp; lra. }
  assert (Rabs (v - Q) <= Rabs (v - c) + Rabs (c - Q)) by (replace (v - Q) with (v - c + (c - Q)) by ring; apply Rabs_triang).
  pose proof (Rabs_pos v); rewrite u_value in *; lra.
Qed.

(** Rounding of a sum and of a product from below: y is at least P − N. *)
Let sum_below (x y P N : R) : 0 <= P -> 0 <= N -> P - N <= x + y -> (1 - u) * P - (1 + u) * N <= add x y.
Proof.
  intros HP HN L; pose proof (sum_error x y) as E; apply Rabs_le_between in E.
  assert (F : (1 - u) * P - (1 + u) * N <= x + y - u * Rabs (x + y)); [|lra].
  unfold Rabs; destruct (Rcase_abs (x + y)); rewrite u_value; lra.
Qed.

Let product_below (x y P N : R) : 0 <= P -> 0 <= N -> P - N <= x * y -> (1 - u) * P - (1 + u) * N - eta <= mul x y.
Proof.
  intros HP HN L; pose proof (product_error x y) as E; apply Rabs_le_between in E.
  assert (F : (1 - u) * P - (1 + u) * N <= x * y - u * Rabs (x * y)); [|lra].
  unfold Rabs; destruct (Rcase_abs (x * y)); rewrite u_value; lra.
Qed.

Let coefficient (Q v r d : R) : known Q v r -> bounds v r d -> (1 - 2 * u) * (h * Rabs v + r) - 3 * eta <= d.
Proof.
  intros K (rho & B & ->); destruct (radius Q v r K) as [R0 _]; pose proof (Rabs_pos v) as V; apply Rabs_le_between in B.
  assert (H : 0 <= h * Rabs v) by (apply Rmult_le_pos; [rewrite h_value, u_value; lra | exact V]).
  pose proof (product_below h (Rabs v) (h * Rabs v) 0 H (Rle_refl 0) ltac:(lra)) as P.
  pose proof (sum_below (mul h (Rabs v)) rho ((1 - u) * (h * Rabs v) + r) (2 * eta)) as S.
  assert (0 <= (1 - u) * (h * Rabs v) + r) by (assert (0 <= (1 - u) * (h * Rabs v)) by (apply Rmult_le_pos; [rewrite u_value; lra | exact H]); lra).
  specialize (S ltac:(lra) ltac:(lra) ltac:(lra)); rewrite h_value, u_value in *; lra.
Qed.

Let start (Q v r d : R) : known Q v r -> bounds v r d -> after 0 v d Q (Rabs v) r.
Proof.
  intros K B; destruct (radius Q v r K) as [R0 E]; pose proof (coefficient Q v r d K B) as C; pose proof (Rabs_pos v).
  unfold after; rewrite h_value, u_value in *; split; [|split; [|split; [|split]]]; lra.
Qed.

(** One step of Horner's scheme, at x from 0 to 1. *)
Let step (n x val bnd E A S Q v r d : R) :
  n = 0 \/ n = 1 \/ n = 2 \/ n = 3 -> 0 <= x <= 1 -> after n val bnd E A S -> known Q v r ->
  (1 - 3 * u) * (h * Rabs v + r) - 4 * eta <= d ->
  after (n + 1) (add (mul val x) v) (add (mul bnd x) d) (Q + E * x) (Rabs v + A * x) (r + S * x).
Proof.
  intros N [X0 X1] (HA & HS & HV & HE & HB) K D; destruct (radius Q v r K) as [R0 C]; pose proof (Rabs_pos v) as V0; pose proof (Rabs_pos val) as W0.
  assert (U : u = / 9007199254740992) by exact u_value; assert (H : h = 32 * u) by exact h_value.
  assert (AX : 0 <= A * x) by now apply Rmult_le_pos. assert (SX : 0 <= S * x) by now apply Rmult_le_pos.
  assert (EX : 0 <= eta * x <= eta) by (split; [now apply Rmult_le_pos | nra]).
  assert (VX : 0 <= Rabs val * x) by now apply Rmult_le_pos.
  (* The product of the value and x. *)
  pose proof (product_error val x) as P; rewrite Rabs_mult, (Rabs_pos_eq x X0) in P.
  pose proof (sum_error (mul val x) v) as Q1.
  assert (P1 : Rabs (mul val x) <= (1 + u) * (Rabs val * x) + eta).
  { replace (mul val x) with (mul val x - val * x + val * x) by ring; eapply Rle_trans; [apply Rabs_triang|].
    rewrite (Rabs_mult val x), (Rabs_pos_eq x X0); lra. }
  assert (Q2 : Rabs (mul val x + v) <= Rabs (mul val x) + Rabs v) by apply Rabs_triang.
  set (p := mul val x) in *; set (w := add p v) in *.
  assert (W1 : Rabs w <= (1 + u) * Rabs (p + v)).
  { replace w with (w - (p + v) + (p + v)) by ring; eapply Rle_trans; [apply Rabs_triang|]; lra. }
  assert (W2 : Rabs (w - (Q + E * x)) <= u * Rabs (p + v) + (u * (Rabs val * x) + eta) + Rabs (val - E) * x + Rabs (v - Q)).
  { replace (w - (Q + E * x)) with (w - (p + v) + (p - val * x) + (val - E) * x + (v - Q)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; apply Rplus_le_compat_r.
    eapply Rle_trans; [apply Rabs_triang|]; rewrite (Rabs_mult (val - E) x), (Rabs_pos_eq x X0); apply Rplus_le_compat_r.
    eapply Rle_trans; [apply Rabs_triang|]; lra. }
  apply (Rmult_le_compat_r x) in HV; [|exact X0]; apply (Rmult_le_compat_r x) in HE; [|exact X0].
  set (y := Rabs (val - E)) in *; set (z := Rabs (w - (Q + E * x))) in *; set (pv := Rabs (p + v)) in *.
  set (q := Rabs (v - Q)) in *; set (t := Rabs p) in *.
  (* The bound. *)
  assert (B : bnd * x >= ((1 - (2 * n + 2) * u) * (h * A + S) - (6 * n + 4) * eta) * x).
  { apply Rle_ge, Rmult_le_compat_r; assumption. }
  set (big := (1 - (2 * n + 2) * u) * (h * (A * x) + S * x)).
  assert (BIG : 0 <= big).
  { unfold big; apply Rmult_le_pos; [rewrite U; destruct N as [->|[->|[->| ->]]]; lra|]; rewrite H, U; lra. }
  pose proof (product_below bnd x big ((6 * n + 4) * eta) BIG) as M1.
  assert (HN : 0 <= (6 * n + 4) * eta) by (destruct N as [->|[->|[->| ->]]]; lra).
  assert (HM : big - (6 * n + 4) * eta <= bnd * x).
  { unfold big; destruct N as [->|[->|[->| ->]]]; lra. }
  specialize (M1 HN HM).
  pose proof (sum_below (mul bnd x) d ((1 - u) * big + (1 - 3 * u) * (h * Rabs v + r)) ((1 + u) * ((6 * n + 4) * eta) + 5 * eta)) as M2.
  assert (G1 : 0 <= (1 - u) * big) by (apply Rmult_le_pos; [rewrite U; lra | exact BIG]).
  assert (G2 : 0 <= (1 - 3 * u) * (h * Rabs v + r)) by (rewrite H, U; lra).
  assert (G3 : 0 <= (1 + u) * ((6 * n + 4) * eta)) by (apply Rmult_le_pos; [rewrite U; lra | exact HN]).
  specialize (M2 ltac:(lra) ltac:(lra) ltac:(lra)); set (b' := add (mul bnd x) d) in *.
  unfold after, big in *; rewrite H, U in *.
  destruct N as [->|[->|[->| ->]]]; (split; [lra|]; split; [lra|]; split; [lra|]; split; [|lra]); change (Rabs (w - (Q + E * x))) with z; lra.
Qed.

(** The last coefficient of the bound gets the absolute part. *)
Let last (Q v r d : R) : known Q v r -> bounds v r d -> (1 - 3 * u) * (h * Rabs v + r) + / 2 * tiny - 4 * eta <= add d tiny.
Proof.
  intros K B; destruct (radius Q v r K) as [R0 _]; pose proof (coefficient Q v r d K B) as C; pose proof (Rabs_pos v) as V.
  assert (U : u = / 9007199254740992) by exact u_value; assert (H : h = 32 * u) by exact h_value.
  assert (P : 0 <= (1 - 2 * u) * (h * Rabs v + r)) by (rewrite H, U; lra).
  pose proof (sum_below d tiny ((1 - 2 * u) * (h * Rabs v + r) + tiny) (3 * eta) ltac:(lra) ltac:(lra) ltac:(lra)) as S.
  rewrite H, U in *; lra.
Qed.

Let inner (Q v r d : R) : known Q v r -> bounds v r d -> (1 - 3 * u) * (h * Rabs v + r) - 4 * eta <= d.
Proof.
  intros K B; destruct (radius Q v r K) as [R0 _]; pose proof (coefficient Q v r d K B) as C; pose proof (Rabs_pos v) as V.
  assert (U : u = / 9007199254740992) by exact u_value; assert (H : h = 32 * u) by exact h_value; rewrite H, U in *; lra.
Qed.

(** What the last step says of the value and the bound decides the sign. *)
Let decided (n val bnd E A S : R) :
  n = 1 \/ n = 4 -> 0 <= A -> 0 <= S -> Rabs val <= (1 + 3 * n * u) * (A + n * eta) ->
  Rabs (val - E) <= (3 * n + 2) * u * A + S + (5 * n + 2) * eta ->
  (1 - (2 * n + 2) * u) * (h * A + S) + / 3 * tiny - (6 * n + 4) * eta <= bnd ->
  bnd < Rabs val -> (0 < val -> 0 < E) /\ (val < 0 -> E < 0).
Proof.
  intros N HA HS HV HE HB L; assert (U : u = / 9007199254740992) by exact u_value; assert (H : h = 32 * u) by exact h_value.
  assert (X : Rabs (val - E) < Rabs val).
  { rewrite H, U in *; destruct N as [->| ->]; lra. }
  clear HE HV HB L; unfold Rabs in X; destruct (Rcase_abs (val - E)), (Rcase_abs val); split; lra.
Qed.

(** The value of a polynomial and its bound as the code computes them, from the highest coefficient down. *)
Let horner2 (c0 c1 x : R) := add (mul c1 x) c0.
Let horner5 (c0 c1 c2 c3 c4 x : R) := add (mul (add (mul (add (mul (add (mul c4 x) c3) x) c2) x) c1) x) c0.

Let last_step (n x val bnd E A S Q v r d : R) :
  n = 0 \/ n = 1 \/ n = 2 \/ n = 3 -> 0 <= x <= 1 -> after n val bnd E A S -> known Q v r -> bounds v r d ->
  let bnd' := add (mul bnd x) (add d tiny) in
  let A' := Rabs v + A * x in let S' := r + S * x in
  0 <= A' /\ 0 <= S' /\ Rabs (add (mul val x) v) <= (1 + 3 * (n + 1) * u) * (A' + (n + 1) * eta) /\
  Rabs (add (mul val x) v - (Q + E * x)) <= (3 * (n + 1) + 2) * u * A' + S' + (5 * (n + 1) + 2) * eta /\
  (1 - (2 * (n + 1) + 2) * u) * (h * A' + S') + / 3 * tiny - (6 * (n + 1) + 4) * eta <= bnd'.
Proof.
  intros N X HI K B bnd' A' S'.
  destruct (step n x val bnd E A S Q v r d N X HI K (inner Q v r d K B)) as (H1 & H2 & H3 & H4 & _).
  split; [exact H1|]; split; [exact H2|]; split; [exact H3|]; split; [exact H4|].
  destruct HI as (HA & HS & _ & _ & HB); destruct (radius Q v r K) as [R0 _]; pose proof (Rabs_pos v) as V0.
  pose proof (last Q v r d K B) as D; destruct X as [X0 X1]; clear H1 H2 H3 H4 step.
  assert (U : u = / 9007199254740992) by exact u_value; assert (H : h = 32 * u) by exact h_value.
  assert (AX : 0 <= A * x) by now apply Rmult_le_pos. assert (SX : 0 <= S * x) by now apply Rmult_le_pos.
  assert (EX : 0 <= eta * x <= eta) by (split; [now apply Rmult_le_pos | nra]).
  apply (Rmult_le_compat_r x) in HB; [|exact X0].
  set (big := (1 - (2 * n + 2) * u) * (h * (A * x) + S * x)).
  assert (BIG : 0 <= big).
  { unfold big; apply Rmult_le_pos; [rewrite U; destruct N as [->|[->|[->| ->]]]; lra|]; rewrite H, U; lra. }
  assert (HN : 0 <= (6 * n + 4) * eta) by (destruct N as [->|[->|[->| ->]]]; lra).
  assert (HM : big - (6 * n + 4) * eta <= bnd * x) by (unfold big; destruct N as [->|[->|[->| ->]]]; lra).
  pose proof (product_below bnd x big ((6 * n + 4) * eta) BIG HN HM) as M1.
  assert (G1 : 0 <= (1 - u) * big) by (apply Rmult_le_pos; [rewrite U; lra | exact BIG]).
  assert (G2 : 0 <= (1 - 3 * u) * (h * Rabs v + r)) by (rewrite H, U; lra).
  assert (G3 : 0 <= (1 + u) * ((6 * n + 4) * eta)) by (apply Rmult_le_pos; [rewrite U; lra | exact HN]).
  pose proof (sum_below (mul bnd x) (add d tiny) ((1 - u) * big + (1 - 3 * u) * (h * Rabs v + r) + / 2 * tiny)
    ((1 + u) * ((6 * n + 4) * eta) + 5 * eta) ltac:(lra) ltac:(lra) ltac:(lra)) as M2.
  fold bnd' in M2; unfold big, A', S' in *; rewrite H, U in *; destruct N as [->|[->|[->| ->]]]; lra.
Qed.

(** The transition's line: where the computed value is larger than the computed bound, it has the sign of Q0 + Q1 x. *)
Theorem line_sign (x Q0 Q1 v0 v1 r0 r1 d0 d1 : R) :
  0 <= x <= 1 -> known Q0 v0 r0 -> known Q1 v1 r1 -> bounds v0 r0 d0 -> bounds v1 r1 d1 ->
  let value := horner2 v0 v1 x in
  horner2 (add d0 tiny) d1 x < Rabs value ->
  (0 < value -> 0 < Q0 + Q1 * x) /\ (value < 0 -> Q0 + Q1 * x < 0).
Proof.
  intros X K0 K1 B0 B1 value L; pose proof (start Q1 v1 r1 d1 K1 B1) as I0.
  destruct (last_step 0 x _ _ _ _ _ Q0 v0 r0 d0 (or_introl eq_refl) X I0 K0 B0) as (H1 & H2 & H3 & H4 & H5).
  replace (0 + 1) with 1 in * by ring.
  exact (decided 1 _ _ _ _ _ (or_introl eq_refl) H1 H2 H3 H4 H5 L).
Qed.

(** The boundary's quartic: the same with five coefficients. *)
Theorem quartic_sign (x Q0 Q1 Q2 Q3 Q4 v0 v1 v2 v3 v4 r0 r1 r2 r3 r4 d0 d1 d2 d3 d4 : R) :
  0 <= x <= 1 -> known Q0 v0 r0 -> known Q1 v1 r1 -> known Q2 v2 r2 -> known Q3 v3 r3 -> known Q4 v4 r4 ->
  bounds v0 r0 d0 -> bounds v1 r1 d1 -> bounds v2 r2 d2 -> bounds v3 r3 d3 -> bounds v4 r4 d4 ->
  let value := horner5 v0 v1 v2 v3 v4 x in
  let polynomial := Q0 + Q1 * x + Q2 * x ^ 2 + Q3 * x ^ 3 + Q4 * x ^ 4 in
  horner5 (add d0 tiny) d1 d2 d3 d4 x < Rabs value ->
  (0 < value -> 0 < polynomial) /\ (value < 0 -> polynomial < 0).
Proof.
  intros X K0 K1 K2 K3 K4 B0 B1 B2 B3 B4 value polynomial L; pose proof (start Q4 v4 r4 d4 K4 B4) as I0.
  pose proof (step 0 x _ _ _ _ _ Q3 v3 r3 d3 ltac:(tauto) X I0 K3 (inner Q3 v3 r3 d3 K3 B3)) as I1; replace (0 + 1) with 1 in I1 by ring.
  pose proof (step 1 x _ _ _ _ _ Q2 v2 r2 d2 ltac:(tauto) X I1 K2 (inner Q2 v2 r2 d2 K2 B2)) as I2; replace (1 + 1) with 2 in I2 by ring.
  pose proof (step 2 x _ _ _ _ _ Q1 v1 r1 d1 ltac:(tauto) X I2 K1 (inner Q1 v1 r1 d1 K1 B1)) as I3; replace (2 + 1) with 3 in I3 by ring.
  destruct (last_step 3 x _ _ _ _ _ Q0 v0 r0 d0 ltac:(tauto) X I3 K0 B0) as (H1 & H2 & H3 & H4 & H5).
  replace (3 + 1) with 4 in * by ring.
  replace polynomial with (Q0 + (Q1 + (Q2 + (Q3 + Q4 * x) * x) * x) * x) by (unfold polynomial; ring).
  exact (decided 4 _ _ _ _ _ (or_intror eq_refl) H1 H2 H3 H4 H5 L).
Qed.

End Filter.

(** ** A point (crates/core/src/stability/certain_signs.rs) *)

Definition group_units : R := 2.
Definition margin_factor : R := 4.
Definition margin_units : R := 2.

Section Margin.

(** Sums and products without underflow, which the code's range of the groups excludes. *)
Variables add mul : R -> R -> R.
Hypotheses
  (sum_error : forall x y, Rabs (add x y - (x + y)) <= unit_roundoff * Rabs (x + y))
  (product_error : forall x y, Rabs (mul x y - x * y) <= unit_roundoff * Rabs (x * y)).

Let u := unit_roundoff.

Let u_value : u = / 9007199254740992.
Proof. unfold u, unit_roundoff; simpl; lra. Qed.

(** The margin κ − (β − 1)(1 + η) of the transition: the computed value differs from it by at most the computed bound, for groups that
    are known to a relative error of two unit roundoffs. *)
Theorem margin_error (kappa beta eta k b h : R) :
  0 < k -> 0 < b -> 0 < h ->
  Rabs (kappa - k) <= group_units * u * k -> Rabs (beta - b) <= group_units * u * b -> Rabs (eta - h) <= group_units * u * h ->
  let value := add k (- mul (add b (- 1)) (add 1 h)) in
  let terms := add k (mul (add 1 b) (add 1 h)) in
  let bound := mul (mul terms margin_factor) (group_units * u + margin_units * u) in
  Rabs (value - (kappa - (beta - 1) * (1 + eta))) <= bound.
Proof.
  intros Pk Pb Ph Ek Eb Eh value terms bound; unfold group_units in Ek, Eb, Eh.
  assert (Bd : bound = mul (mul terms 4) (2 * u + 2 * u)) by reflexivity; clearbody bound.
  pose proof u_value as U; fold u in sum_error, product_error.
  set (T := (1 + b) * (1 + h)); assert (T0 : 0 < T) by (unfold T; apply Rmult_lt_0_compat; lra).
  (* The sums. *)
  pose proof (sum_error b (- 1)) as E1; pose proof (sum_error 1 h) as E2; pose proof (sum_error 1 b) as E3.
  rewrite (Rabs_pos_eq (1 + h)) in E2 by lra; rewrite (Rabs_pos_eq (1 + b)) in E3 by lra.
  assert (B1 : Rabs (b + - 1) <= 1 + b) by (apply Rabs_le; lra).
  set (s1 := add b (- 1)) in *; set (s2 := add 1 h) in *; set (s3 := add 1 b) in *.
  apply Rabs_le_between in E2; apply Rabs_le_between in E3.
  assert (S1 : Rabs (s1 - (b + - 1)) <= u * (1 + b)) by (rewrite U in *; lra).
  assert (S1' : Rabs s1 <= (1 + u) * (1 + b)).
  { replace s1 with (s1 - (b + - 1) + (b + - 1)) by ring; eapply Rle_trans; [apply Rabs_triang|]; lra. }
  assert (S2 : (1 - u) * (1 + h) <= s2 <= (1 + u) * (1 + h)) by lra.
  assert (S3 : (1 - u) * (1 + b) <= s3) by lra.
  assert (P2 : 0 < s2) by (rewrite U in S2; lra). assert (P3 : 0 < s3) by (rewrite U in S3; lra).
  (* The products. *)
  assert (M1 : Rabs (s1 * s2) <= (1 + u) * (1 + u) * T).
  { rewrite Rabs_mult, (Rabs_pos_eq s2) by lra.
    replace ((1 + u) * (1 + u) * T) with ((1 + u) * (1 + b) * ((1 + u) * (1 + h))) by (unfold T; ring).
    apply Rmult_le_compat; try apply Rabs_pos; try lra. }
  assert (M2 : Rabs (s1 * s2 - (b - 1) * (1 + h)) <= (2 * u + u * u) * T).
  { replace (s1 * s2 - (b - 1) * (1 + h)) with ((s1 - (b + - 1)) * s2 + (b + - 1) * (s2 - (1 + h))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; rewrite !Rabs_mult, (Rabs_pos_eq s2) by lra.
    assert (X1 : Rabs (s1 - (b + - 1)) * s2 <= u * (1 + b) * ((1 + u) * (1 + h))) by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    assert (X2 : Rabs (b + - 1) * Rabs (s2 - (1 + h)) <= (1 + b) * (u * (1 + h))).
    { apply Rmult_le_compat; try apply Rabs_pos; [lra | apply Rabs_le; lra]. }
    unfold T; lra. }
  pose proof (product_error s1 s2) as E4; set (m := mul s1 s2) in *.
  assert (M3 : Rabs (m - (b - 1) * (1 + h)) <= 4 * u * T).
  { replace (m - (b - 1) * (1 + h)) with (m - s1 * s2 + (s1 * s2 - (b - 1) * (1 + h))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; rewrite U in *; lra. }
  (* The exact margin. *)
  assert (G : Rabs ((b - 1) * (1 + h) - (beta - 1) * (1 + eta)) <= (4 * u + 4 * u * u) * T).
  { replace ((b - 1) * (1 + h) - (beta - 1) * (1 + eta)) with (- ((beta - b) * (1 + eta)) + - ((b - 1) * (eta - h))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; rewrite !Rabs_Ropp, !Rabs_mult.
    assert (N1 : Rabs (1 + eta) <= (1 + 2 * u) * (1 + h)) by (apply Rabs_le_between in Eh; apply Rabs_le; rewrite U in *; lra).
    assert (X1 : Rabs (beta - b) * Rabs (1 + eta) <= 2 * u * b * ((1 + 2 * u) * (1 + h))) by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    assert (X2 : Rabs (b - 1) * Rabs (eta - h) <= (1 + b) * (2 * u * h)) by (apply Rmult_le_compat; try apply Rabs_pos; [exact B1 | lra]).
    assert (0 < b * h) by now apply Rmult_lt_0_compat.
    unfold T; rewrite U in *; lra. }
  pose proof (sum_error k (- m)) as E5; fold value in E5.
  assert (M4 : Rabs m <= 2 * T).
  { replace m with (m - s1 * s2 + s1 * s2) by ring; eapply Rle_trans; [apply Rabs_triang|]; rewrite U in *; lra. }
  assert (K1 : Rabs (k + - m) <= k + 2 * T).
  { eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp, (Rabs_pos_eq k) by lra; lra. }
  assert (V : Rabs (value - (kappa - (beta - 1) * (1 + eta))) <= 3 * u * k + 11 * u * T).
  { replace (value - (kappa - (beta - 1) * (1 + eta)))
      with (value - (k + - m) + - (kappa - k) + (- (m - (b - 1) * (1 + h)) + - ((b - 1) * (1 + h) - (beta - 1) * (1 + eta)))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans; [apply Rplus_le_compat; apply Rabs_triang|]; rewrite !Rabs_Ropp.
    rewrite U in *; lra. }
  (* The bound. *)
  assert (Q1 : (1 - u) * (1 - u) * T <= s3 * s2).
  { replace ((1 - u) * (1 - u) * T) with ((1 - u) * (1 + b) * ((1 - u) * (1 + h))) by (unfold T; ring).
    apply Rmult_le_compat; try lra; rewrite U; lra. }
  pose proof (product_error s3 s2) as E6; rewrite (Rabs_pos_eq (s3 * s2)) in E6 by (left; now apply Rmult_lt_0_compat).
  set (n := mul s3 s2) in *; apply Rabs_le_between in E6.
  assert (Q2 : (1 - 4 * u) * T <= n) by (rewrite U in *; lra).
  assert (P5 : 0 < n) by (rewrite U in Q2; lra).
  pose proof (sum_error k n) as E7; fold terms in E7; rewrite (Rabs_pos_eq (k + n)) in E7 by lra; apply Rabs_le_between in E7.
  assert (Q3 : (1 - 6 * u) * (k + T) <= terms) by (rewrite U in *; lra).
  assert (P6 : 0 < terms) by (rewrite U in Q3; lra).
  pose proof (product_error terms 4) as E8; rewrite (Rabs_pos_eq (terms * 4)) in E8 by lra; apply Rabs_le_between in E8.
  set (r := mul terms 4) in *; assert (P7 : 0 < r) by (rewrite U in *; lra).
  assert (W : 0 < 2 * u + 2 * u) by (rewrite U; lra).
  pose proof (product_error r (2 * u + 2 * u)) as E9; fold r in Bd; rewrite <- Bd in E9.
  rewrite (Rabs_pos_eq (r * (2 * u + 2 * u))) in E9 by (left; now apply Rmult_lt_0_compat); apply Rabs_le_between in E9.
  rewrite U in *; lra.
Qed.

End Margin.
