(** What generated proofs use: signs by form, divisors that are not zero, and a few lemmas on functions. *)

From Coq Require Export Reals Lra Psatz List.
From Coquelicot Require Export Coquelicot.
Export ListNotations.
Open Scope R_scope.

(** ** Signs by form *)

Ltac pos :=
  lazymatch goal with
  | |- 0 < ?a + ?b => first [assumption | apply Rplus_lt_0_compat; pos]
  | |- 0 < ?a * ?b => first [assumption | apply Rmult_lt_0_compat; pos]
  | |- 0 < ?a / ?b => first [assumption | apply Rdiv_lt_0_compat; pos]
  | |- 0 < / ?a => apply Rinv_0_lt_compat; pos
  | |- 0 < ?a ^ ?n => apply pow_lt; pos
  | |- 0 < exp _ => apply exp_pos
  | |- 0 < sqrt ?a - sqrt ?b => first [assumption | apply Rlt_Rminus, sqrt_lt_1; lra]
  | |- 0 < sqrt _ => apply sqrt_lt_R0; pos
  | |- 0 < IZR (Zpos _) => apply IZR_lt; reflexivity
  | |- _ => first [assumption | lra]
  end.

Lemma opposite_negative (x : R) : 0 < x -> - x < 0.
Proof. lra. Qed.

Ltac nonneg :=
  lazymatch goal with
  | |- 0 <= ?a + ?b => first [assumption | left; pos | apply Rplus_le_le_0_compat; nonneg | nra]
  | |- 0 <= ?a * ?b => first [assumption | apply Rmult_le_pos; nonneg]
  | |- 0 <= ?a / ?b => first [assumption | apply Rdiv_le_0_compat; [nonneg | pos]]
  | |- 0 <= ?a ^ ?n => first [assumption | apply pow_le; nonneg]
  | |- _ => first [assumption | left; pos | apply Rle_refl | nra]
  end.

(** A sum of which one term is positive and the others are not negative. *)
Ltac one_pos :=
  first
    [ pos
    | apply Rplus_le_lt_0_compat; [nonneg | one_pos]
    | apply Rplus_lt_le_0_compat; [one_pos | nonneg] ].

Ltac negative := first [apply opposite_negative; one_pos | lra].

Ltac divisor :=
  first
    [ assumption
    | lazymatch goal with
      | |- ?a * ?b <> 0 => apply Rmult_integral_contrapositive_currified; divisor
      | |- ?a / ?b <> 0 => apply Rmult_integral_contrapositive_currified; [divisor | apply Rinv_neq_0_compat; divisor]
      | |- / ?a <> 0 => apply Rinv_neq_0_compat; divisor
      | |- ?a ^ ?n <> 0 => apply pow_nonzero; divisor
      | |- - ?a <> 0 => apply Ropp_neq_0_compat; divisor
      end
    | apply Rgt_not_eq; red; pos
    | apply Rgt_not_eq; red; ring_simplify; pos
    | apply Rlt_not_eq; apply Ropp_lt_cancel; rewrite Ropp_0; ring_simplify; pos
    | match goal with H : ?p <> 0 |- _ => let z := fresh in intro z; apply H; lra end
    | match goal with H : ?p <> 0 |- _ => let z := fresh in intro z; apply H; nra end
    | nra ].

(** Conditions that [field] leaves. *)
Ltac divisors := repeat split; divisor.

Ltac project := apply injective_projections; cbn [fst snd Cplus Cmult Copp Cminus Cdiv Cinv RtoC Ci].

(** ** Functions *)

Lemma root_squared (x : R) : 0 <= x -> sqrt x ^ 2 = x.
Proof. intros H; simpl; rewrite Rmult_1_r; now apply sqrt_sqrt. Qed.

Lemma root_of_square (x r : R) : 0 <= r -> x = r * r -> sqrt x = r.
Proof. intros H ->; now apply sqrt_square. Qed.

Lemma root_of_quotient (n d : R) : 0 <= n -> 0 < d -> sqrt (n / d) = sqrt (n * d) / d.
Proof.
  intros Hn Hd.
  replace (n / d) with (n * d / (d * d)) by (field; lra).
  rewrite sqrt_div; [ | now apply Rmult_le_pos; [ | left] | now apply Rmult_lt_0_compat].
  now rewrite sqrt_square by lra.
Qed.

Lemma absolute_positive (x r : R) : 0 < r -> x = r -> Rabs x = r.
Proof. intros H ->; apply Rabs_pos_eq; lra. Qed.

Lemma absolute_negative (x r : R) : 0 < r -> x = - r -> Rabs x = r.
Proof. intros H ->; rewrite Rabs_Ropp; apply Rabs_pos_eq; lra. Qed.

Lemma ln_power (x : R) (n : nat) : 0 < x -> ln (x ^ n) = INR n * ln x.
Proof.
  intros H; induction n as [|n IH]; [simpl; rewrite ln_1; ring|].
  rewrite S_INR; simpl pow; rewrite ln_mult by (auto; now apply pow_lt).
  rewrite IH; ring.
Qed.

Lemma ln_quotient (x y : R) : 0 < x -> 0 < y -> ln (x / y) = ln x - ln y.
Proof. intros Hx Hy; unfold Rdiv; rewrite ln_mult, ln_Rinv by (auto; now apply Rinv_0_lt_compat); ring. Qed.

(** The logarithm of a product of positive factors falls apart. *)
Ltac logarithms :=
  repeat first
    [ rewrite ln_1 | rewrite ln_exp | rewrite ln_quotient by pos | rewrite ln_mult by pos | rewrite ln_power by pos ];
  simpl INR.

(** A square root in the goal has this value. *)
Ltac root_is r :=
  match goal with
  | |- context [sqrt ?x] =>
      let h := fresh in
      assert (h : sqrt x = r) by (apply root_of_square; first [lra | field; lra]); rewrite h; clear h
  end.

(** The hypotheses of a theorem hold at the point that has been named. *)
Ltac possible :=
  repeat match goal with |- _ /\ _ => split end;
  first [ reflexivity | lra | field_simplify; lra | nra | let h := fresh in intro h; lra ].
