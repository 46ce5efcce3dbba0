(** Slip with the load point at rest below the critical stiffness: claim Q5 of Ranjith and Rice (1999). *)

From Slipmode Require Export Tactics.

Lemma falling (f f' : R -> R) (s t : R) :
  s <= t -> (forall r, s <= r <= t -> is_derive f r (f' r) /\ f' r <= 0) -> f t <= f s.
Proof.
  intros O F; destruct (Req_dec s t) as [->|N]; [lra|].
  destruct (MVT_gen f s t f') as (r & R1 & R2).
  - rewrite Rmin_left, Rmax_right by lra; intros r R; apply F; lra.
  - rewrite Rmin_left, Rmax_right by lra; intros r R; apply continuity_pt_filterlim.
    apply (ex_derive_continuous (V := R_NormedModule)); exists (f' r); apply F; lra.
  - rewrite Rmin_left, Rmax_right in R1 by lra; destruct (F r R1) as [_ F2].
    assert (0 <= - f' r * (t - s)) by (apply Rmult_le_pos; lra); lra.
Qed.

(** A solution of q' = p q with p not negative keeps its sign. *)
Lemma same_sign (q p : R -> R) (t : R) :
  0 <= t -> (forall r, 0 <= r <= t -> is_derive q r (p r * q r) /\ 0 <= p r) -> 0 < q 0 -> 0 < q t.
Proof.
  intros T D Q; assert (S : forall s, 0 <= s <= t -> q 0 ^ 2 <= q s ^ 2).
  { intros s H; assert (- q s ^ 2 <= - q 0 ^ 2); [|lra].
    apply (falling (fun r => - q r ^ 2) (fun r => - (2 * p r * q r ^ 2))); [lra|]; intros r Hr; destruct (D r ltac:(lra)) as [E P]; split.
    - auto_derive; [exists (p r * q r); exact E|]; rewrite (is_derive_unique (fun x : R => q x) r _ E).
      match goal with |- ?u = ?v => change (u = v :> R) end; ring.
    - assert (0 <= p r * q r ^ 2) by (apply Rmult_le_pos; [exact P | apply pow2_ge_0]); lra. }
  destruct (Rlt_le_dec 0 (q t)) as [|N]; [assumption|]; exfalso.
  destruct (IVT_gen (fun r => q (Rmax 0 (Rmin t r))) 0 t 0) as (s & S1 & S2).
  - intros r; apply continuity_pt_filterlim.
    apply (continuous_comp (fun r => Rmax 0 (Rmin t r)) q).
    + apply continuity_pt_filterlim; intros e He; exists e; split; [exact He|]; intros y [_ Y]; simpl in *; unfold R_dist in *.
      unfold Rmax, Rmin; repeat destruct Rle_dec; unfold Rabs in *; repeat destruct Rcase_abs; lra.
    + apply (ex_derive_continuous (V := R_NormedModule)); eexists; apply D; unfold Rmax, Rmin; repeat destruct Rle_dec; lra.
  - rewrite (Rmin_right t 0), (Rmin_left t t), (Rmax_left 0 0), (Rmax_right 0 t) by lra; rewrite Rmin_right, Rmax_left by lra; lra.
  - rewrite Rmin_left, Rmax_right in S1 by lra; rewrite (Rmin_right t s), (Rmax_right 0 s) in S2 by lra.
    pose proof (S s S1) as X; rewrite S2 in X; assert (0 < q 0 ^ 2) by now apply pow_lt. lra.
Qed.

Section Runaway.

Variables A B L K : R.
Hypotheses (A_pos : 0 < A) (weakening : A < B) (L_pos : 0 < L) (K_pos : 0 < K).

(** Eqs 2, 6 and 7. *)
Let aging (v theta : R) := 1 - v * theta / L.
Let at_rest (K v : R) := - K * v.
Let K_cr := (B - A) / L.

(** A motion until T: friction, with the slopes A/v and B/θ, follows the spring. *)
Let moves (T : R) (v theta v' : R -> R) : Prop := forall t, 0 <= t <= T ->
  0 < v t /\ 0 < theta t /\ is_derive v t (v' t) /\ is_derive theta t (aging (v t) (theta t)) /\
  v' t = (at_rest K (v t) - B / theta t * aging (v t) (theta t)) / (A / v t).

Let c := B - A.
Let q (v theta : R -> R) (t : R) := L / (v t * theta t) - (c - K * L) / c.

Let slope (T : R) (v theta v' : R -> R) : moves T v theta v' -> forall t, 0 <= t <= T ->
  is_derive (q v theta) t (c / (A * theta t) * q v theta t) /\ 0 <= c / (A * theta t).
Proof using A_pos weakening L_pos.
  intros m t H; destruct (m t H) as (Pv & Pt & Dv & Dt & E); assert (C : 0 < c) by (unfold c; lra); split; [|left; pos].
  unfold q; auto_derive; [repeat split; try (eexists; eassumption); apply Rgt_not_eq; red; pos|].
  rewrite (is_derive_unique (fun x : R => v x) t _ Dv), (is_derive_unique (fun x : R => theta x) t _ Dt), E.
  match goal with |- ?u = ?v => change (u = v :> R) end; unfold aging, at_rest, c in *; field; repeat split; lra.
Qed.

(** Claim Q5: below K_cr the slip rate falls as long as a motion lasts from every start in one region; from every start in another it is
    at least v(0)/(1 − K v(0) t/(B − A)), so that it becomes infinite in finite time. Both regions have points at every state. *)
Theorem Q5 : K < K_cr ->
  (forall T v theta v', moves T v theta v' -> 0 < B - (B - K * L) * (v 0 * theta 0 / L) ->
     forall t, 0 <= t <= T -> v' t < 0) /\
  (forall state, 0 < state -> exists v, 0 < v /\ 0 < B - (B - K * L) * (v * state / L)) /\
  (forall T v theta v', moves T v theta v' -> 0 < (B - A - K * L) * (v 0 * theta 0 / L) - (B - A) ->
     forall t, 0 <= t <= T -> v 0 <= v t * (1 - K * v 0 * t / (B - A)) /\ t < (B - A) / (K * v 0)) /\
  (forall state, 0 < state -> exists v, 0 < v /\ 0 < (B - A - K * L) * (v * state / L) - (B - A)).
Proof using A_pos weakening L_pos K_pos slope.
  intros H; assert (C : 0 < c) by (unfold c; lra).
  assert (G : 0 < c - K * L).
  { apply (Rmult_lt_compat_r L) in H; [|exact L_pos]; replace (K_cr * L) with c in H by (unfold K_cr, c; field; lra); lra. }
  assert (KL : 0 < K * L) by pos; assert (B0 : 0 < B - K * L) by (unfold c in G; lra).
  fold c; split; [|split; [|split]].
  - intros T v theta v' m S t Ht; destruct (m t Ht) as (Pv & Pt & _ & _ & E); destruct (m 0 ltac:(lra)) as (Pv0 & Pt0 & _).
    set (x0 := v 0 * theta 0 / L) in *; assert (X0 : 0 < x0) by (unfold x0; pos).
    assert (Q : forall s, 0 <= s <= t -> 0 < q v theta s).
    { intros s Hs; apply (same_sign (q v theta) (fun r => c / (A * theta r))); [lra| |].
      - intros r Hr; apply (slope T v theta v' m); lra.
      - unfold q; replace (L / (v 0 * theta 0)) with (/ x0) by (unfold x0; field; lra).
        apply (Rmult_lt_reg_r (x0 * c)); [pos|]; replace ((/ x0 - (c - K * L) / c) * (x0 * c)) with (c - (c - K * L) * x0) by (field; lra).
        assert (B * (c - K * L) < c * (B - K * L)) by (unfold c; nra).
        assert ((B - K * L) * ((c - K * L) * x0) < B * (c - K * L)) by nra. nra. }
    assert (F : - q v theta t <= - q v theta 0).
    { apply (falling (fun r => - q v theta r) (fun r => - (c / (A * theta r) * q v theta r))); [lra|].
      intros r Hr; destruct (slope T v theta v' m r ltac:(lra)) as [D P]; split; [apply (is_derive_opp (q v theta)); exact D|].
      pose proof (Q r Hr); assert (0 <= c / (A * theta r) * q v theta r) by (apply Rmult_le_pos; lra); lra. }
    set (x := v t * theta t / L); assert (X : 0 < x) by (unfold x; pos).
    assert (XX : x <= x0).
    { unfold q in F; replace (L / (v t * theta t)) with (/ x) in F by (unfold x; field; lra).
      replace (L / (v 0 * theta 0)) with (/ x0) in F by (unfold x0; field; lra).
      destruct (Rle_lt_dec x x0) as [|W]; [assumption|]; exfalso.
      assert (/ x < / x0) by (apply Rinv_lt_contravar; [now apply Rmult_lt_0_compat | exact W]). lra. }
    assert (V : v t = x * L / theta t) by (unfold x; field; lra).
    rewrite E; unfold aging, at_rest; fold x.
    replace ((- K * v t - B / theta t * (1 - x)) / (A / v t)) with (- (v t / (A * theta t) * (K * L * x + B * (1 - x))))
      by (unfold x; field; repeat split; lra).
    assert (0 < K * L * x + B * (1 - x)) by nra.
    assert (0 < v t / (A * theta t) * (K * L * x + B * (1 - x))) by (apply Rmult_lt_0_compat; [pos | assumption]). lra.
  - intros state P; exists (L / (2 * state)); split; [pos|].
    replace (L / (2 * state) * state / L) with (/ 2) by (field; lra). lra.
  - intros T v theta v' m S t Ht; destruct (m t Ht) as (Pv & Pt & _); destruct (m 0 ltac:(lra)) as (Pv0 & Pt0 & _).
    set (x0 := v 0 * theta 0 / L) in *; assert (X0 : 0 < x0) by (unfold x0; pos).
    assert (Q : forall s, 0 <= s <= t -> 0 < - q v theta s).
    { intros s Hs; apply (same_sign (fun r => - q v theta r) (fun r => c / (A * theta r))); [lra| |].
      - intros r Hr; destruct (slope T v theta v' m r ltac:(lra)) as [D P]; split; [|exact P].
        rewrite Ropp_mult_distr_r_reverse; apply (is_derive_opp (q v theta)); exact D.
      - unfold q; replace (L / (v 0 * theta 0)) with (/ x0) by (unfold x0; field; lra).
        apply (Rmult_lt_reg_r (x0 * c)); [pos|]; replace (- (/ x0 - (c - K * L) / c) * (x0 * c)) with ((c - K * L) * x0 - c) by (field; lra).
        lra. }
    assert (F : / v t + K / c * t <= / v 0 + K / c * 0).
    { apply (falling (fun r => / v r + K / c * r) (fun r => - v' r / v r ^ 2 + K / c)); [lra|].
      intros r Hr; destruct (m r ltac:(lra)) as (Qv & Qt & Dv & _ & E); split.
      - auto_derive; [split; [exists (v' r); exact Dv | split; [lra | exact I]]|].
        rewrite (is_derive_unique (fun x : R => v x) r _ Dv); match goal with |- ?u = ?v => change (u = v :> R) end; field; lra.
      - pose proof (Q r Hr) as W; unfold q in W; set (x := v r * theta r / L); assert (X : 0 < x) by (unfold x; pos).
        replace (L / (v r * theta r)) with (/ x) in W by (unfold x; field; lra).
        assert (Y : c < (c - K * L) * x).
        { apply (Rmult_lt_compat_r (x * c)) in W; [|pos].
          replace (- (/ x - (c - K * L) / c) * (x * c)) with ((c - K * L) * x - c) in W by (field; lra). lra. }
        rewrite E; unfold aging, at_rest; fold x.
        replace (- ((- K * v r - B / theta r * (1 - x)) / (A / v r)) / v r ^ 2 + K / c)
          with (- ((B * c - K * L * B) * x - B * c) / (A * c * L * x))
          by (unfold x, c; field; unfold c in C; repeat split; lra).
        assert (0 < ((B * c - K * L * B) * x - B * c) / (A * c * L * x)); [|unfold Rdiv in *; lra].
        apply Rdiv_lt_0_compat; [|pos].
        replace ((B * c - K * L * B) * x - B * c) with (B * ((c - K * L) * x - c)) by ring.
        apply Rmult_lt_0_compat; lra. }
    assert (G1 : v 0 <= v t * (1 - K * v 0 * t / c)).
    { apply (Rmult_le_compat_l (v t * v 0)) in F; [|left; now apply Rmult_lt_0_compat].
      replace (v t * v 0 * (/ v t + K / c * t)) with (v 0 + v t * (K * v 0 * t / c)) in F by (field; lra).
      replace (v t * v 0 * (/ v 0 + K / c * 0)) with (v t) in F by (field; lra). lra. }
    split; [exact G1|].
    apply (Rmult_lt_reg_r (K * v 0 / c)); [pos|].
    replace (c / (K * v 0) * (K * v 0 / c)) with 1 by (field; lra).
    replace (t * (K * v 0 / c)) with (K * v 0 * t / c) by (field; lra).
    destruct (Rlt_le_dec (K * v 0 * t / c) 1) as [|W]; [assumption|]; exfalso.
    assert (0 <= v t * (K * v 0 * t / c - 1)) by (apply Rmult_le_pos; lra). lra.
  - intros state P; exists (2 * L * c / ((c - K * L) * state)); split; [pos|].
    replace ((c - K * L) * (2 * L * c / ((c - K * L) * state) * state / L)) with (2 * c) by (field; lra). lra.
Qed.

End Runaway.
