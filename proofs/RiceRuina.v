(** One slider of Rice and Ruina (1983) with the aging and with the slip law, with and without inertia: claims R1 to R9. *)

From Slipmode Require Export Transition.

(** An equation between what Coquelicot has as elements of a module. *)
Ltac real := match goal with |- ?u = ?v => change (u = v :> R) end.

(** The characteristic polynomials of a system of three and of two equations, det (s − J). *)
Definition determinant3 (j11 j12 j13 j21 j22 j23 j31 j32 j33 : R) (s : C) : C :=
  ((s - RtoC j11) * ((s - RtoC j22) * (s - RtoC j33) - RtoC j23 * RtoC j32) -
   RtoC j12 * (RtoC j21 * (s - RtoC j33) + RtoC j23 * RtoC j31) -
   RtoC j13 * (RtoC j21 * RtoC j32 + (s - RtoC j22) * RtoC j31))%C.

Definition determinant2 (j11 j12 j21 j22 : R) (s : C) : C :=
  ((s - RtoC j11) * (s - RtoC j22) - RtoC j12 * RtoC j21)%C.

Section Jacobians.

Variables r1 r2 r3 : R -> R -> R -> R.

(** A polynomial is the characteristic one of a system at a steady state, by the derivatives of the rates. *)
Definition characteristic3 (x y z : R) (P : C -> C) : Prop :=
  r1 x y z = 0 /\ r2 x y z = 0 /\ r3 x y z = 0 /\
  exists j11 j12 j13 j21 j22 j23 j31 j32 j33,
    is_derive (fun t => r1 t y z) x j11 /\ is_derive (fun t => r1 x t z) y j12 /\ is_derive (fun t => r1 x y t) z j13 /\
    is_derive (fun t => r2 t y z) x j21 /\ is_derive (fun t => r2 x t z) y j22 /\ is_derive (fun t => r2 x y t) z j23 /\
    is_derive (fun t => r3 t y z) x j31 /\ is_derive (fun t => r3 x t z) y j32 /\ is_derive (fun t => r3 x y t) z j33 /\
    forall s, P s = determinant3 j11 j12 j13 j21 j22 j23 j31 j32 j33 s.

Variables q1 q2 : R -> R -> R.

Definition characteristic2 (x y : R) (P : C -> C) : Prop :=
  q1 x y = 0 /\ q2 x y = 0 /\
  exists j11 j12 j21 j22,
    is_derive (fun t => q1 t y) x j11 /\ is_derive (fun t => q1 x t) y j12 /\
    is_derive (fun t => q2 t y) x j21 /\ is_derive (fun t => q2 x t) y j22 /\
    forall s, P s = determinant2 j11 j12 j21 j22 s.

End Jacobians.

Definition all_decay (P : C -> C) : Prop := forall s, P s = 0%C -> fst s < 0.
Definition one_grows (P : C -> C) : Prop := exists s, P s = 0%C /\ 0 < fst s.

Section RiceRuina.

Variables A B L V V_r tau_0 : R.
Hypotheses (A_pos : 0 < A) (B_pos : 0 < B) (L_pos : 0 < L) (V_pos : 0 < V) (V_r_pos : 0 < V_r).

(** Eqs 1 to 7. *)
Let tau (v theta : R) := tau_0 + A * ln (v / V_r) + B * ln (theta * V_r / L).
Let aging (v theta : R) := 1 - v * theta / L.
Let slip (v theta : R) := - v * theta / L * ln (v * theta / L).
Let theta_ss := L / V.
Let spring (K v : R) := K * (V - v).
Let motion (M f tau : R) := (f - tau) / M.
Let tau_ss := tau_0 - (B - A) * ln (V / V_r).

(** Eqs 8 to 10. *)
Let K_cr := (B - A) / L.
Let K_c (M : R) := (B - A) / L * (1 + M * V ^ 2 / (A * L)).
Let omega := V / L * sqrt ((B - A) / A).

(** The slopes of eq 1, by which friction follows the spring's stress where there is no mass. *)
Let direct (v theta : R) := A / v.
Let by_state (v theta : R) := B / theta.

Lemma slopes (v theta : R) : 0 < v -> 0 < theta ->
  is_derive (fun v => tau v theta) v (direct v theta) /\ is_derive (fun theta => tau v theta) theta (by_state v theta).
Proof using A_pos L_pos V_r_pos.
  intros Pv Pt; unfold tau, direct, by_state; split; auto_derive; try (repeat split; try exact I; pos);
    real; field; repeat split; lra.
Qed.

(** What follows holds for both laws: [law] is one of them. *)
Let is_law (law : R -> R -> R) := law = aging \/ law = slip.

Let with_mass (law : R -> R -> R) (K M : R) (P : C -> C) :=
  characteristic3 (fun f v theta => spring K v) (fun f v theta => motion M f (tau v theta)) (fun f v theta => law v theta)
    tau_ss V theta_ss P.

Let without_mass (law : R -> R -> R) (K : R) (P : C -> C) :=
  characteristic2 (fun v theta => (spring K v - by_state v theta * law v theta) / direct v theta) law V theta_ss P.

Let law_at_rest (law : R -> R -> R) : is_law law ->
  law V theta_ss = 0 /\ is_derive (fun v => law v theta_ss) V (- (1 / V)) /\ is_derive (fun theta => law V theta) theta_ss (- (V / L)).
Proof using L_pos V_pos.
  assert (E : V * (L / V) / L = 1) by (field; lra).
  unfold theta_ss; intros [-> | ->]; [unfold aging|unfold slip]; (split; [|split]).
  - rewrite E; ring.
  - auto_derive; [exact I|]; real; field; lra.
  - auto_derive; [exact I|]; real; field; lra.
  - rewrite E, ln_1; ring.
  - auto_derive; [replace (V * (L / V) * / L) with 1 by (field; lra); lra|].
    replace (V * (L / V) * / L) with 1 by (field; lra); rewrite ln_1.
    real; field; lra.
  - auto_derive; [replace (V * (L / V) * / L) with 1 by (field; lra); lra|].
    replace (V * (L / V) * / L) with 1 by (field; lra); rewrite ln_1.
    real; field; lra.
Qed.

Let state_pos : 0 < theta_ss.
Proof using L_pos V_pos. unfold theta_ss; pos. Qed.

(** With mass the characteristic polynomial is eq 8 of Im and Avouac over the mass, at unit normal stress. *)
Let P (K M : R) (s : C) : C :=
  (RtoC (/ M) * complex_cubic (M / 1) (A / V + M * V / (1 * L)) (K / 1 + (A - B) / L) (K * V / (1 * L)) s)%C.

Let P_massless (K : R) : C -> C := quadratic 1 (V / A * (K - K_cr)) (K * V ^ 2 / (A * L)).

Theorem linearised (law : R -> R -> R) (K M : R) : is_law law -> 0 < M -> with_mass law K M (P K M).
Proof using A_pos L_pos V_pos V_r_pos.
  intros H m; destruct (law_at_rest law H) as (Z & DV & DT); pose proof state_pos as T.
  destruct (slopes V theta_ss V_pos T) as [TV TT].
  split; [unfold spring; ring|]; split.
  { unfold motion, tau_ss, tau, theta_ss.
    replace (L / V * V_r / L) with (/ (V / V_r)) by (field; lra); rewrite ln_Rinv by pos; field; lra. }
  split; [exact Z|].
  exists 0, (- K), 0, (/ M), (- (direct V theta_ss / M)), (- (by_state V theta_ss / M)), 0, (- (1 / V)), (- (V / L)).
  repeat match goal with |- _ /\ _ => split end; try assumption; try apply (is_derive_const (V := R_NormedModule)).
  - apply (is_derive_ext (fun v => K * (V - v))); [reflexivity|]; auto_derive; [exact I|]; real; ring.
  - apply (is_derive_ext (fun f => (f - tau V theta_ss) / M)); [reflexivity|]; auto_derive; [exact I|]; real; field; lra.
  - unfold motion; apply (is_derive_ext (fun v => tau_ss / M + - / M * tau v theta_ss)); [intros t; real; unfold motion; field; lra|].
    auto_derive; [exists (direct V theta_ss); exact TV|]; rewrite (is_derive_unique (fun x : R => tau x theta_ss) V _ TV).
    real; field; lra.
  - unfold motion; apply (is_derive_ext (fun theta => tau_ss / M + - / M * tau V theta)); [intros t; real; unfold motion; field; lra|].
    auto_derive; [exists (by_state V theta_ss); exact TT|]; rewrite (is_derive_unique (fun x : R => tau V x) theta_ss _ TT).
    real; field; lra.
  - intros [x y]; unfold P, complex_cubic, determinant3, direct, by_state, theta_ss; project; field; repeat split; lra.
Qed.

Theorem linearised_massless (law : R -> R -> R) (K : R) : is_law law -> without_mass law K (P_massless K).
Proof using A_pos L_pos V_pos.
  intros H; destruct (law_at_rest law H) as (Z & DV & DT); pose proof state_pos as T.
  split; [rewrite Z; unfold spring, direct; field; lra|]; split; [exact Z|].
  exists (- K * V / A + B * V / (A * L)), (B * V ^ 3 / (A * L ^ 2)), (- (1 / V)), (- (V / L)).
  split; [|split; [|split; [exact DV | split; [exact DT|]]]].
  - unfold direct, by_state, spring.
    apply (is_derive_ext (fun v => (K * (V - v) - B / theta_ss * law v theta_ss) * (v / A))).
    { intros t; real; unfold Rdiv; rewrite Rinv_mult, Rinv_inv; ring. }
    auto_derive; [exists (- (1 / V)); exact DV|]; rewrite (is_derive_unique (fun x : R => law x theta_ss) V _ DV), Z; unfold theta_ss.
    real; field; repeat split; lra.
  - unfold direct, by_state, spring.
    apply (is_derive_ext (fun theta => (K * (V - V) - B / theta * law V theta) * (V / A))).
    { intros t; real; unfold Rdiv; rewrite Rinv_mult, Rinv_inv; ring. }
    auto_derive; [repeat split; [lra | exists (- (V / L)); exact DT]|]; rewrite (is_derive_unique (fun x : R => law V x) theta_ss _ DT), Z; unfold theta_ss.
    real; field; repeat split; lra.
  - intros [x y]; unfold P_massless, quadratic, determinant2, K_cr; project; field; repeat split; lra.
Qed.

(** ** With mass *)

Let with_unit_stress (M : R) : (B - A) * 1 / L * (1 + M * V ^ 2 / (1 * A * L)) = K_c M.
Proof using A_pos L_pos. unfold K_c; field; lra. Qed.

Let roots_of (K M : R) (s : C) : 0 < M ->
  (P K M s = 0%C <-> complex_cubic (M / 1) (A / V + M * V / (1 * L)) (K / 1 + (A - B) / L) (K * V / (1 * L)) s = 0%C).
Proof using.
  intros m; unfold P; split; intros H; [|rewrite H; ring].
  apply integral in H; destruct H as [H|H]; [|exact H].
  exfalso; apply (f_equal fst) in H; simpl in H; assert (0 < / M) by now apply Rinv_0_lt_compat. lra.
Qed.

Theorem stability (K M : R) : 0 < K -> 0 < M ->
  (all_decay (P K M) <-> K_c M < K) /\ (one_grows (P K M) <-> K < K_c M).
Proof using A_pos L_pos V_pos.
  intros k m; destruct (S1 A B L K M 1 V A_pos L_pos k m Rlt_0_1 V_pos) as (H1 & H2 & _).
  rewrite with_unit_stress in H1, H2; rewrite <- H1, <- H2; unfold all_decay, one_grows, stable; split; split.
  - intros H s Z; apply H; now apply roots_of.
  - intros H s Z; apply H; now apply roots_of in Z.
  - intros (s & Z & X); exists s; split; [now apply roots_of in Z | exact X].
  - intros (s & Z & X); exists s; split; [now apply roots_of | exact X].
Qed.

Theorem neutral (M : R) : 0 < M -> A < B ->
  0 < omega /\ P (K_c M) M (Ci * RtoC omega)%C = 0%C /\ P (K_c M) M (- (Ci * RtoC omega))%C = 0%C.
Proof using A_pos L_pos V_pos.
  intros m H; split; [unfold omega; assert (0 < B - A) by lra; pos|].
  assert (E : sqrt ((B - A) / A) * V / L = omega) by (unfold omega; field; lra).
  split; apply roots_of; try exact m; rewrite <- (with_unit_stress M);
    rewrite (S6 A B M A_pos m L V 1 _ L_pos V_pos Rlt_0_1 H), E; ring.
Qed.

(** Claim R1, for the polynomial of either law ([linearised]). *)
Theorem R1 (M : R) : 0 < M ->
  (forall K, 0 < K -> P K M 0%C <> 0%C) /\
  (A < B -> P (K_c M) M (Ci * RtoC omega)%C = 0%C /\ 0 < omega) /\
  (A < B -> exists (e : R) (k w : R -> R) (k' : R), 0 < e /\ k' < 0 /\ is_derive k 0 k' /\ continuous w 0 /\ k 0 = K_c M /\
     w 0 = omega /\ forall t, Rabs t < e -> 0 < k t /\ 0 < w t /\ P (k t) M (t, w t) = 0%C) /\
  (forall K, 0 < K -> (all_decay (P K M) <-> K_c M < K) /\ (one_grows (P K M) <-> K < K_c M)) /\
  (forall K, 0 < K -> B <= A -> all_decay (P K M)).
Proof using A_pos B_pos L_pos V_pos.
  intros m; split; [|split; [|split; [|split]]].
  - intros K k H; apply roots_of in H; [|exact m]; apply (f_equal fst) in H; unfold complex_cubic in H; simpl in H.
    assert (0 < K * V / (1 * L)) by pos; lra.
  - intros H; destruct (neutral M m H) as (W & Z & _); split; assumption.
  - intros H; destruct (S1_crossing A B M A_pos B_pos m L V 1 L_pos V_pos Rlt_0_1 H) as (e & k & w & k' & E & N & DK & CW & K0 & W0 & R).
    exists e, k, w, k'; do 4 (split; [assumption|]); split; [rewrite K0; apply with_unit_stress|].
    split; [rewrite W0; unfold omega; field; lra|].
    intros t T; destruct (R t T) as (P1 & P2 & Z); split; [exact P1|]; split; [exact P2|]; now apply roots_of.
  - intros K k; now apply stability.
  - intros K k H; apply stability; try assumption.
    assert (K_c M <= 0); [|lra]; unfold K_c.
    replace ((B - A) / L * (1 + M * V ^ 2 / (A * L))) with (- ((A - B) * ((1 + M * V ^ 2 / (A * L)) / L))) by (field; lra).
    assert (0 <= (A - B) * ((1 + M * V ^ 2 / (A * L)) / L)) by (apply Rmult_le_pos; [lra | left; pos]); lra.
Qed.

(** ** Without mass *)

(** Claim R2. *)
Theorem R2 (K : R) : 0 < K -> (all_decay (P_massless K) <-> K_cr < K) /\ (one_grows (P_massless K) <-> K < K_cr).
Proof using A_pos L_pos V_pos.
  intros k; assert (Q : 0 < K * V ^ 2 / (A * L)) by pos; assert (W : 0 < V / A) by pos; unfold P_massless, all_decay, one_grows; split.
  - rewrite quadratic_stable by lra; split; [intros [H _]; nra | intros H; split; [nra | exact Q]].
  - split.
    + intros ([x y] & Z & X); simpl in X; apply quadratic_parts in Z; destruct Z as [Z1 Z2].
      apply Rmult_integral in Z2; destruct (Rlt_le_dec K K_cr) as [|H]; [assumption|]; exfalso.
      assert (0 <= V / A * (K - K_cr)) by (apply Rmult_le_pos; lra); destruct Z2 as [->|Z2]; nra.
    + intros H; destruct (quadratic_root 1 (V / A * (K - K_cr)) (K * V ^ 2 / (A * L)) ltac:(lra)) as (x & y & Z & X & _).
      exists (x, y); split; [exact Z | simpl; nra].
Qed.

(** Claims R3 and R5: with and without mass the pair crosses at the same frequency, which is not zero. *)
Theorem R3 : A < B ->
  0 < omega /\ P_massless K_cr (Ci * RtoC omega)%C = 0%C /\ P_massless K_cr (- (Ci * RtoC omega))%C = 0%C /\
  (forall K s, P_massless K s = 0%C -> snd s <> 0 -> fst s = V / (2 * A) * (K_cr - K)).
Proof using A_pos L_pos V_pos.
  intros H; assert (W : 0 < B - A) by lra; split; [unfold omega; pos|].
  assert (E : omega ^ 2 = K_cr * V ^ 2 / (A * L)).
  { unfold omega, K_cr; rewrite Rpow_mult_distr, root_squared by (left; pos); field; lra. }
  split; [|split].
  - unfold P_massless, quadratic; rewrite <- E; project; ring.
  - unfold P_massless, quadratic; rewrite <- E; project; ring.
  - intros K [x y] Z N; apply quadratic_parts in Z; destruct Z as [_ Z]; simpl in *.
    apply Rmult_integral in Z; destruct Z as [Z|Z]; [contradiction|].
    replace x with ((2 * 1 * x + V / A * (K - K_cr)) / 2 + V / (2 * A) * (K_cr - K)) by (field; lra); rewrite Z; field; lra.
Qed.

Theorem R5 (M : R) : 0 < M -> A < B -> P (K_c M) M (Ci * RtoC omega)%C = 0%C /\ P_massless K_cr (Ci * RtoC omega)%C = 0%C.
Proof using A_pos L_pos V_pos. intros m H; split; [exact (proj1 (proj2 (neutral M m H))) | exact (proj1 (proj2 (R3 H)))]. Qed.

(** Claim R4. *)
Theorem R4 : A < B ->
  (forall K M, 0 < K -> 0 < M -> (all_decay (P K M) <-> K_c M < K) /\ (one_grows (P K M) <-> K < K_c M)) /\
  (forall M, 0 < M -> K_cr < K_c M) /\ (forall M N, 0 < M -> M < N -> K_c M < K_c N).
Proof using A_pos L_pos V_pos.
  intros H; assert (W : 0 < (B - A) / L) by (assert (0 < B - A) by lra; pos).
  assert (G : 0 < V ^ 2 / (A * L)) by pos.
  assert (E : forall M, K_c M = (B - A) / L + (B - A) / L * (V ^ 2 / (A * L)) * M) by (intros M; unfold K_c; field; lra).
  assert (F : 0 < (B - A) / L * (V ^ 2 / (A * L))) by now apply Rmult_lt_0_compat.
  split; [intros; now apply stability|]; split; intros M; rewrite ?E; [unfold K_cr|intros N; rewrite E]; nra.
Qed.

(** Claim R6. *)
Theorem R6 (K M : R) : 0 < K -> 0 < M -> B <= A -> all_decay (P K M) /\ all_decay (P_massless K).
Proof using A_pos B_pos L_pos V_pos.
  intros k m H; split; [now apply (R1 M m)|]; apply R2; [exact k|].
  assert (K_cr <= 0); [|lra]; unfold K_cr, Rdiv; assert (0 < / L) by now apply Rinv_0_lt_compat. nra.
Qed.

(** Claim R7: both laws have the same polynomials, so that the conditions are the same. *)
Theorem R7 (K M : R) : 0 < K -> 0 < M ->
  with_mass aging K M (P K M) /\ with_mass slip K M (P K M) /\ without_mass aging K (P_massless K) /\
  without_mass slip K (P_massless K).
Proof using A_pos L_pos V_pos V_r_pos.
  intros k m; split; [|split; [|split]]; try apply linearised; try apply linearised_massless; try exact m; unfold is_law; auto.
Qed.

(** Claim R8. *)
Theorem R8 : filterlim K_c (at_right 0) (locally K_cr).
Proof using A_pos L_pos.
  apply (limit_at_zero _ [(B - A) / L; (B - A) / L * (V ^ 2 / (A * L))] [1]);
    [intros M m; unfold K_c; simpl; field; lra | simpl; lra | unfold K_cr; simpl; field; lra].
Qed.

End RiceRuina.

Section Rapid.

Variables A B L : R.
Hypotheses (A_pos : 0 < A) (weakening : A < B) (L_pos : 0 < L).

(** Eqs 9 and 11. *)
Let critical (M V : R) := (B - A) / L * (1 + M * V ^ 2 / (A * L)).
Let K_rapid (M V : R) := M * V ^ 2 * (B - A) / (A * L ^ 2).

(** Claim R9. *)
Theorem R9 :
  (forall M, 0 < M -> filterlim (fun V => critical M V / K_rapid M V) (Rbar_locally p_infty) (locally 1)) /\
  (forall V, 0 < V -> filterlim (fun M => critical M V / K_rapid M V) (Rbar_locally p_infty) (locally 1)).
Proof using A_pos weakening L_pos.
  unfold critical, K_rapid; split.
  - intros M m; apply (limit_at_infinity _ [1; 0; A * L / M] [1]);
      [intros V v; simpl; field; repeat split; lra | simpl; lra | simpl; field; lra].
  - intros V v; apply (limit_at_infinity _ [1; A * L / V ^ 2] [1]);
      [intros M m; simpl; field; repeat split; lra | simpl; lra | simpl; field; lra].
Qed.

End Rapid.
