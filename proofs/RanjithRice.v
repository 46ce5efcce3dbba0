(** What inertia changes in Ranjith and Rice (1999), and slip with the load point at rest: claims Q4, Q7 and Q8. *)

From Slipmode Require Export RiceRuina.

Section RanjithRice.

Variables A B L V V_r tau_0 : R.
Hypotheses (A_pos : 0 < A) (weakening : A < B) (L_pos : 0 < L) (V_pos : 0 < V) (V_r_pos : 0 < V_r).

(** Eqs 1, 2 and 4 to 10. *)
Let tau (v theta : R) := tau_0 + A * ln (v / V_r) + B * ln (theta * V_r / L).
Let aging (v theta : R) := 1 - v * theta / L.
Let theta_ss := L / V.
Let spring (K v : R) := K * (V - v).
Let at_rest (K v : R) := - K * v.
Let K_cr := (B - A) / L.
Let motion (M f tau : R) := (f - tau) / M.
Let tau_ss := tau_0 - (B - A) * ln (V / V_r).
Let K_c (M : R) := (B - A) / L * (1 + M * V ^ 2 / (A * L)).

(** P is the characteristic polynomial of steady sliding with mass. *)
Let with_mass (K M : R) (P : C -> C) :=
  characteristic3 (fun f v theta => spring K v) (fun f v theta => motion M f (tau v theta)) (fun f v theta => aging v theta)
    tau_ss V theta_ss P.

Let B_pos : 0 < B.
Proof using A_pos weakening. lra. Qed.

Let polynomial (K M : R) : 0 < K -> 0 < M -> exists P, with_mass K M P /\
  (all_decay P <-> K_c M < K) /\ (one_grows P <-> K < K_c M) /\ P 0%C = RtoC (K * V / (L * M)).
Proof using A_pos L_pos V_pos V_r_pos.
  intros k m; destruct (stability A B L V A_pos L_pos V_pos K M k m) as [H1 H2].
  pose proof (linearised A B L V V_r tau_0 A_pos L_pos V_pos V_r_pos aging K M (or_introl eq_refl) m) as H3.
  eexists; split; [exact H3|]; split; [exact H1|]; split; [exact H2|].
  unfold complex_cubic; project; field; lra.
Qed.

Let above (M : R) : 0 < M -> K_cr < K_c M.
Proof using A_pos weakening L_pos V_pos.
  intros m; unfold K_cr, K_c; assert (0 < (B - A) / L) by (assert (0 < B - A) by lra; pos).
  assert (0 < (B - A) / L * (M * V ^ 2 / (A * L))) by pos; lra.
Qed.

Let K_cr_pos : 0 < K_cr.
Proof using weakening L_pos. assert (0 < B - A) by lra; unfold K_cr; pos. Qed.

(** Claim Q8: with mass steady sliding is unstable exactly for K < K_c, which is larger than K_cr and tends to it as the mass tends to zero. *)
Theorem Q8 :
  (forall K M, 0 < K -> 0 < M -> exists P, with_mass K M P /\ (one_grows P <-> K < K_c M)) /\
  (forall M, 0 < M -> K_cr < K_c M) /\ filterlim K_c (at_right 0) (locally K_cr).
Proof using A_pos weakening L_pos V_pos V_r_pos polynomial above.
  split; [|split; [exact above|]].
  - intros K M k m; destruct (polynomial K M k m) as (P & H & _ & G & _); now exists P.
  - exact (R8 A B L V A_pos L_pos).
Qed.

(** Claim Q7 fails for every mass: at K_cr a disturbance grows, between K_cr and K_c steady sliding is not stable, and the
    characteristic polynomial is positive at zero, so that a root is real and negative at every K. *)
Theorem Q7 (M : R) : 0 < M ->
  (exists P, with_mass K_cr M P /\ one_grows P) /\
  (forall K, K_cr < K -> K < K_c M -> exists P, with_mass K M P /\ ~ all_decay P) /\
  (forall K, 0 < K -> exists P p, with_mass K M P /\ P 0%C = RtoC p /\ 0 < p).
Proof using A_pos weakening L_pos V_pos V_r_pos polynomial above K_cr_pos.
  intros m; pose proof K_cr_pos as KP; split; [|split].
  - destruct (polynomial K_cr M KP m) as (P & H & _ & G & _); exists P; split; [exact H|]; apply G; now apply above.
  - intros K H1 H2; destruct (polynomial K M ltac:(lra) m) as (P & H & S & _); exists P; split; [exact H|].
    intros D; apply S in D; lra.
  - intros K k; destruct (polynomial K M k m) as (P & H & _ & _ & Z); exists P, (K * V / (L * M)); split; [exact H|].
    split; [exact Z | pos].
Qed.

(** Claim Q4 in its first reading fails: without inertia and with the load point at rest some starts accelerate, for every K from K_cr up
    to B/L. The acceleration is the one with which friction (its slopes are [direct] and [by_state]) follows the spring. *)
Theorem Q4 (K : R) : K_cr <= K -> K < B / L ->
  exists v theta direct by_state, 0 < v /\ 0 < theta /\
    is_derive (fun v => tau v theta) v direct /\ is_derive (fun theta => tau v theta) theta by_state /\
    0 < (at_rest K v - by_state * aging v theta) / direct.
Proof using A_pos weakening L_pos V_r_pos K_cr_pos.
  intros H1 H2; pose proof K_cr_pos as KP.
  assert (G : 0 < B - K * L).
  { apply (Rmult_lt_compat_r L) in H2; [|exact L_pos]; replace (B / L * L) with B in H2 by (field; lra); lra. }
  set (v := 2 * B * L / (B - K * L)); assert (Pv : 0 < v) by (unfold v; pos).
  exists v, 1, (A / v), B; split; [exact Pv|]; split; [lra|]; split; [|split].
  - unfold tau; auto_derive; [repeat split; try exact I; pos|]; real; field; repeat split; lra.
  - unfold tau; auto_derive; [repeat split; try exact I; pos|]; real; field; repeat split; lra.
  - unfold at_rest, aging; replace ((- K * v - B * (1 - v * 1 / L)) / (A / v)) with (B * v / A)
      by (unfold v; field; repeat split; lra).
    pos.
Qed.

(** Claim Q4 in its second reading: every motion with the load point at rest and K from K_cr up decelerates from some time on, and
    its velocity tends to zero. A motion is a solution for all times from zero on. *)
Theorem Q4_late (K : R) (v theta v' : R -> R) : K_cr <= K ->
  (forall t, 0 <= t -> 0 < v t /\ 0 < theta t /\ is_derive v t (v' t) /\ is_derive theta t (aging (v t) (theta t)) /\
     v' t = (at_rest K (v t) - B / theta t * aging (v t) (theta t)) / (A / v t)) ->
  (exists T, forall t, T <= t -> v' t < 0) /\ filterlim v (Rbar_locally p_infty) (locally 0).
Proof using A_pos weakening L_pos K_cr_pos.
  intros H1 m; pose proof K_cr_pos as KP.
  assert (G : 0 <= K * L - (B - A)).
  { apply (Rmult_le_compat_r L) in H1; [|lra]; replace (K_cr * L) with (B - A) in H1 by (unfold K_cr; field; lra); lra. }
  set (c := B - A); assert (C : 0 < c) by (unfold c; lra).
  set (x := fun t => v t * theta t / L); set (g := fun t => ln (v t * theta t)).
  (* The slope of the logarithm of v θ. *)
  set (g' := fun t => - (c + (K * L - c) * x t) / (A * theta t)).
  assert (X : forall t, 0 <= t -> 0 < x t) by (intros t P; destruct (m t P) as (Pv & Pt & _); unfold x; pos).
  assert (DG : forall t, 0 <= t -> is_derive g t (g' t)).
  { intros t P; destruct (m t P) as (Pv & Pt & Dv & Dt & E); unfold g.
    auto_derive; [repeat split; try (eexists; eassumption); pos|].
    rewrite (is_derive_unique (fun x : R => v x) t _ Dv), (is_derive_unique (fun x : R => theta x) t _ Dt), E.
    unfold g', x, aging, at_rest, c; real; field; repeat split; lra. }
  assert (BG : forall t, 0 <= t -> g' t <= - (c / A) * / theta t).
  { intros t P; destruct (m t P) as (_ & Pt & _); unfold g'.
    replace (- (c + (K * L - c) * x t) / (A * theta t)) with (- (c / A) * / theta t - (K * L - c) * x t * / (A * theta t)) by (field; lra).
    assert (0 <= (K * L - c) * x t * / (A * theta t)); [|lra].
    apply Rmult_le_pos; [apply Rmult_le_pos; [exact G | left; now apply X] | left; apply Rinv_0_lt_compat; pos]. }
  assert (falls : forall (f f' : R -> R) s t, 0 <= s -> s <= t -> (forall r, s <= r <= t -> is_derive f r (f' r) /\ f' r <= 0) -> f t <= f s).
  { intros f f' s t P O F; destruct (Req_dec s t) as [->|N]; [lra|].
    destruct (MVT_gen f s t f') as (r & R1 & R2).
    - rewrite Rmin_left, Rmax_right by lra; intros r R; apply F; lra.
    - rewrite Rmin_left, Rmax_right by lra; intros r R; apply continuity_pt_filterlim.
      apply (ex_derive_continuous (V := R_NormedModule)); exists (f' r); apply F; lra.
    - rewrite Rmin_left, Rmax_right in R1 by lra; destruct (F r R1) as [_ F2].
      assert (f' r * (t - s) <= 0); [|lra]. assert (0 <= - f' r * (t - s)) by (apply Rmult_le_pos; lra). lra. }
  (* The product v θ falls, so that x stays below 1 once it is there. *)
  assert (down : forall s t, 0 <= s -> s <= t -> x t <= x s).
  { intros s t P O; assert (Q : g t <= g s).
    { apply (falls g g'); try assumption; intros r R; split; [apply DG; lra|]; eapply Rle_trans; [apply BG; lra|].
      destruct (m r ltac:(lra)) as (_ & Pt & _); assert (0 < / theta r) by now apply Rinv_0_lt_compat.
      assert (0 < c / A) by pos; nra. }
    destruct (m s P) as (Pv & Pt & _); destruct (m t ltac:(lra)) as (Qv & Qt & _); unfold g in Q; unfold x, Rdiv.
    apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|].
    destruct (Rle_lt_dec (v t * theta t) (v s * theta s)) as [|W]; [assumption|]; apply ln_increasing in W; [lra | pos]. }
  (* It gets there: before, θ falls. *)
  assert (there : exists T, 0 <= T /\ x T < 1).
  { destruct (m 0 ltac:(lra)) as (Pv & Pt & _).
    set (k := c / (A * theta 0)); assert (PK : 0 < k) by (unfold k; pos).
    set (T := Rmax 0 ((g 0 - ln L) / k + 1)); assert (T0 : 0 <= T) by apply Rmax_l.
    exists T; split; [exact T0|]; destruct (Rlt_le_dec (x T) 1) as [|W]; [assumption|]; exfalso.
    assert (small : forall r, 0 <= r <= T -> theta r <= theta 0).
    { intros r R; apply (falls theta (fun t => aging (v t) (theta t))); try lra.
      intros q Q; destruct (m q ltac:(lra)) as (_ & _ & _ & D & _); split; [exact D|].
      pose proof (down q T ltac:(lra) ltac:(lra)); unfold aging; fold (x q); unfold x in *; lra. }
    assert (F : g T + k * T <= g 0 + k * 0).
    { apply (falls (fun t => g t + k * t) (fun t => g' t + k)); try lra.
      intros r R; split.
      - apply (is_derive_plus g (fun t => k * t)); [apply DG; lra|]; auto_derive; [exact I|]; real; ring.
      - pose proof (BG r ltac:(lra)) as Q; destruct (m r ltac:(lra)) as (_ & Pr & _).
        pose proof (small r R) as S; assert (/ theta 0 <= / theta r) by (apply Rinv_le_contravar; lra).
        assert (c / A * / theta 0 <= c / A * / theta r) by (apply Rmult_le_compat_l; [left; pos | assumption]).
        assert (k = c / A * / theta 0) by (unfold k; field; lra). lra. }
    assert (GL : ln L <= g T).
    { unfold g; assert (L <= v T * theta T).
      { apply (Rmult_le_compat_r L) in W; [|lra]; unfold x in W; replace (v T * theta T / L * L) with (v T * theta T) in W by (field; lra); lra. }
      destruct (Req_dec L (v T * theta T)) as [<-|]; [lra|]; left; apply ln_increasing; lra. }
    assert (TK : (g 0 - ln L) / k + 1 <= T) by apply Rmax_r.
    apply (Rmult_le_compat_r k) in TK; [|lra]; replace (((g 0 - ln L) / k + 1) * k) with (g 0 - ln L + k) in TK by (field; lra). lra. }
  destruct there as (T & T0 & XT).
  assert (below : forall t, T <= t -> 0 < aging (v t) (theta t) <= 1).
  { intros t Q; pose proof (down T t T0 Q); pose proof (X t ltac:(lra)); unfold aging; fold (x t); unfold x in *; lra. }
  split.
  - exists T; intros t Q; destruct (m t ltac:(lra)) as (Pv & Pt & _ & _ & E); rewrite E; destruct (below t Q) as [W _].
    replace ((at_rest K (v t) - B / theta t * aging (v t) (theta t)) / (A / v t))
      with (- (v t / A * (K * v t + B / theta t * aging (v t) (theta t)))) by (unfold at_rest; field; repeat split; lra).
    assert (0 < v t / A * (K * v t + B / theta t * aging (v t) (theta t))); [|lra].
    assert (0 < K) by lra; assert (0 < B) by lra.
    apply Rmult_lt_0_compat; [pos|]; apply Rplus_lt_0_compat; [pos|]; apply Rmult_lt_0_compat; [pos | exact W].
  - destruct (m T T0) as (_ & PT & _).
    assert (grows : forall t, T <= t -> theta T <= theta t <= theta T + (t - T)).
    { intros t Q; split.
      - assert (- theta t <= - theta T); [|lra].
        apply (falls (fun t => - theta t) (fun t => - aging (v t) (theta t))); try assumption.
        intros r R; destruct (below r ltac:(lra)) as [W _]; destruct (m r ltac:(lra)) as (_ & _ & _ & D & _); split; [|lra].
        apply (is_derive_opp theta); exact D.
      - assert (theta t + - 1 * t <= theta T + - 1 * T); [|lra].
        apply (falls (fun t => theta t + - 1 * t) (fun t => aging (v t) (theta t) + - 1)); try assumption.
        intros r R; destruct (below r ltac:(lra)) as [_ W]; destruct (m r ltac:(lra)) as (_ & _ & _ & D & _); split; [|lra].
        apply (is_derive_plus theta (fun t => - 1 * t)); [exact D|]; auto_derive; [exact I|]; real; ring. }
    set (late := fun t => ln (theta T + (t - T))).
    assert (F : forall t, T <= t -> g t + c / A * late t <= g T + c / A * late T).
    { intros t Q; apply (falls (fun t => g t + c / A * late t) (fun t => g' t + c / A * / (theta T + (t - T)))); try assumption.
      intros r R; split.
      - apply (is_derive_plus g (fun t => c / A * late t)); [apply DG; lra|]; unfold late; auto_derive; [lra|]; real; field; lra.
      - pose proof (BG r ltac:(lra)) as W; destruct (grows r ltac:(lra)) as [G1 G2].
        assert (/ (theta T + (r - T)) <= / theta r) by (apply Rinv_le_contravar; lra).
        assert (c / A * / (theta T + (r - T)) <= c / A * / theta r) by (apply Rmult_le_compat_l; [left; pos | assumption]). lra. }
    apply filterlim_locally; intros e; assert (E0 : 0 < e) by apply cond_pos.
    set (far := exp ((g T + c / A * late T - ln (e * theta T)) * (A / c))); assert (F0 : 0 < far) by apply exp_pos.
    exists (T + far); intros t Q; destruct (m t ltac:(lra)) as (Pv & Pt & _); destruct (grows t ltac:(lra)) as [G1 _].
    assert (N : ln far < late t) by (unfold late; apply ln_increasing; lra).
    unfold far in N; rewrite ln_exp in N.
    assert (CA : 0 < c / A) by pos.
    apply (Rmult_lt_compat_l (c / A)) in N; [|exact CA].
    replace (c / A * ((g T + c / A * late T - ln (e * theta T)) * (A / c))) with (g T + c / A * late T - ln (e * theta T)) in N by (field; lra).
    pose proof (F t ltac:(lra)) as W.
    assert (Y : ln (v t * theta t) < ln (e * theta T)) by (unfold g in *; lra).
    apply ln_lt_inv in Y; [|pos | now apply Rmult_lt_0_compat].
    assert (Z : v t < e) by (destruct (Rlt_le_dec (v t) e) as [|Z]; [assumption|]; exfalso; nra).
    unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl; rewrite Ropp_0, Rplus_0_r, Rabs_pos_eq; lra.
Qed.

End RanjithRice.
