(** A single root of a polynomial at x = 0 continues as a branch, and a truncated series that solves the
    equation up to some order is that close to the branch. *)

From Slipmode Require Export Functions.

(** A polynomial in y whose coefficients are polynomials in x. *)
Definition both (p : list (list R)) (x y : R) : R := horner (map (fun c => horner c x) p) y.

(** The derivative of a polynomial. *)
Fixpoint slope (p : list R) (y : R) : R :=
  match p with [] => 0 | c :: q => horner q y + y * slope q y end.

Lemma horner_derivative (p : list R) (y : R) : is_derive (horner p) y (slope p y).
Proof.
  induction p as [|c q IH]; [apply (is_derive_const (V := R_NormedModule))|].
  apply (is_derive_ext (fun y => c + y * horner q y)); [reflexivity|].
  replace (slope (c :: q) y) with (0 + (1 * horner q y + y * slope q y)) by (simpl; ring).
  apply (is_derive_plus (V := R_NormedModule) (fun _ => c) (fun y => y * horner q y));
    [apply (is_derive_const (V := R_NormedModule))|].
  apply (is_derive_mult (fun y => y) (horner q)); [apply (is_derive_id y) | exact IH | apply Rmult_comm].
Qed.

Lemma horner_continuity_2d (c : list R) (x y : R) : continuity_2d_pt (fun x _ => horner c x) x y.
Proof.
  apply (continuity_1d_2d_pt_comp (horner c) (fun x _ => x)); [apply horner_continuity | apply continuity_2d_pt_id1].
Qed.

Lemma both_continuity (p : list (list R)) (x y : R) : continuity_2d_pt (both p) x y.
Proof.
  induction p as [|c q IH]; [exact (continuity_2d_pt_const x y 0)|].
  apply (continuity_2d_pt_plus (fun x _ => horner c x) (fun x y => y * both q x y)); [apply horner_continuity_2d|].
  apply (continuity_2d_pt_mult (fun _ y => y) (both q)); [apply continuity_2d_pt_id2 | exact IH].
Qed.

Lemma slope_continuity (p : list (list R)) (x y : R) :
  continuity_2d_pt (fun x y => slope (map (fun c => horner c x) p) y) x y.
Proof.
  induction p as [|c q IH]; [exact (continuity_2d_pt_const x y 0)|].
  apply (continuity_2d_pt_plus (both q) (fun x y => y * slope (map (fun c => horner c x) q) y)); [apply both_continuity|].
  apply (continuity_2d_pt_mult (fun _ y => y) (fun x y => slope (map (fun c => horner c x) q) y));
    [apply continuity_2d_pt_id2 | exact IH].
Qed.

Lemma near_zero (f : R -> R) (e : R) :
  continuity_pt f 0 -> 0 < e -> exists d, 0 < d /\ forall x, Rabs x < d -> Rabs (f x - f 0) < e.
Proof.
  intros C E; destruct (C e E) as (d & D & H); exists d; split; [exact D|]; intros x X.
  destruct (Req_dec x 0) as [->|N]; [rewrite Rminus_diag_eq, Rabs_R0; auto|].
  apply H; split; [split; [exact I | now apply not_eq_sym]|].
  unfold dist; simpl; unfold R_dist; rewrite Rminus_0_r; exact X.
Qed.

(** The branch, where the slope at the root is positive. *)
Lemma branch_up (p : list (list R)) (s g : list R) (n : nat) :
  (0 < n)%nat ->
  (forall x, both p x (horner s x) = x ^ n * horner g x) ->
  0 < slope (map (fun c => horner c 0) p) (horner s 0) ->
  exists e k, 0 < e /\ 0 < k /\
    forall x, Rabs x < e -> exists y, both p x y = 0 /\ Rabs (y - horner s x) <= k * Rabs x ^ n.
Proof.
  intros N Z M; set (F := fun x y => slope (map (fun c => horner c x) p) y) in *.
  change (0 < F 0 (horner s 0)) in M; set (m := F 0 (horner s 0)) in *.
  destruct (slope_continuity p 0 (horner s 0) (mkposreal (m / 2) ltac:(lra))) as [d D]; simpl in D.
  destruct (near_zero (horner s) (d / 2)) as (d1 & D1 & S); [apply horner_continuity | destruct d; simpl; lra |].
  destruct (near_zero (horner g) 1) as (d2 & D2 & G); [apply horner_continuity | lra |].
  set (b := Rabs (horner g 0) + 1).
  assert (B : 0 < b) by (unfold b; pose proof (Rabs_pos (horner g 0)); lra).
  set (k := 2 * b / m); assert (K : 0 < k) by (unfold k; apply Rdiv_lt_0_compat; lra).
  set (r := Rmin 1 (d / (4 * k))).
  assert (R0 : 0 < r) by (apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; [apply cond_pos | lra]]).
  exists (Rmin (Rmin d1 d2) (Rmin d r)), k.
  split; [apply Rmin_pos; apply Rmin_pos; [exact D1 | exact D2 | apply cond_pos | exact R0]|]; split; [exact K|]; intros x X.
  assert (X1 : Rabs x < d1) by (eapply Rlt_le_trans; [exact X | eapply Rle_trans; [apply Rmin_l | apply Rmin_l]]).
  assert (X2 : Rabs x < d2) by (eapply Rlt_le_trans; [exact X | eapply Rle_trans; [apply Rmin_l | apply Rmin_r]]).
  assert (X3 : Rabs x < d) by (eapply Rlt_le_trans; [exact X | eapply Rle_trans; [apply Rmin_r | apply Rmin_l]]).
  assert (X4 : Rabs x < r) by (eapply Rlt_le_trans; [exact X | eapply Rle_trans; [apply Rmin_r | apply Rmin_r]]).
  pose proof (Rabs_pos x) as X0.
  assert (P : Rabs x ^ n <= Rabs x).
  { destruct n as [|n]; [lia|]; simpl.
    assert (Rabs x ^ n <= 1).
    { rewrite <- (pow1 n); apply pow_incr; split; [exact X0|].
      left; eapply Rlt_le_trans; [exact X4 | apply Rmin_l]. }
    apply Rle_trans with (Rabs x * 1); [now apply Rmult_le_compat_l | lra]. }
  set (h := k * Rabs x ^ n).
  assert (H0 : 0 <= h) by (apply Rmult_le_pos; [lra | now apply pow_le]).
  assert (H1 : h < d / 2).
  { unfold h; apply Rle_lt_trans with (k * Rabs x); [apply Rmult_le_compat_l; lra|].
    apply Rlt_le_trans with (k * r); [apply Rmult_lt_compat_l; lra|].
    apply Rle_trans with (k * (d / (4 * k))); [apply Rmult_le_compat_l; [lra | apply Rmin_r]|].
    replace (k * (d / (4 * k))) with (d / 4) by (field; lra); pose proof (cond_pos d); lra. }
  specialize (S x X1); specialize (G x X2).
  set (y0 := horner s x) in *.
  assert (FB : forall y, Rabs (y - y0) <= h -> m / 2 < F x y).
  { intros y Y; assert (A : Rabs (F x y - m) < m / 2).
    { apply D; [now rewrite Rminus_0_r|].
      replace (y - horner s 0) with ((y - y0) + (y0 - horner s 0)) by ring.
      eapply Rle_lt_trans; [apply Rabs_triang|]; lra. }
    apply Rabs_def2 in A; lra. }
  assert (GB : Rabs (both p x y0) <= m / 2 * h).
  { rewrite Z, Rabs_mult, <- RPow_abs.
    replace (m / 2 * h) with (Rabs x ^ n * b) by (unfold h, k; field; lra).
    apply Rmult_le_compat_l; [now apply pow_le|].
    replace (horner g x) with (horner g 0 + (horner g x - horner g 0)) by ring.
    eapply Rle_trans; [apply Rabs_triang | unfold b; lra]. }
  destruct H0 as [H0|H0].
  2: { exists y0; split.
       - rewrite <- H0, Rmult_0_r in GB; pose proof (Rabs_pos (both p x y0)).
         destruct (Req_dec (both p x y0) 0) as [|Q]; [assumption | apply Rabs_no_R0 in Q; lra].
       - rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra. }
  assert (V : forall y, is_derive (both p x) y (F x y)) by (intros y; apply horner_derivative).
  assert (CV : forall y, continuity_pt (both p x) y).
  { intros y; apply continuity_pt_filterlim, (ex_derive_continuous (both p x)); eexists; apply V. }
  assert (UP : 0 <= both p x (y0 + h)).
  { destruct (MVT_gen (both p x) y0 (y0 + h) (F x)) as (c & C & E); [intros; apply V | intros; apply CV |].
    rewrite Rmin_left, Rmax_right in C by lra.
    assert (m / 2 < F x c) by (apply FB; apply Rabs_le; lra).
    assert (m / 2 * h <= F x c * (y0 + h - y0)).
    { replace (y0 + h - y0) with h by ring; apply Rmult_le_compat_r; lra. }
    apply Rabs_le_between in GB; lra. }
  assert (DOWN : both p x (y0 - h) <= 0).
  { destruct (MVT_gen (both p x) (y0 - h) y0 (F x)) as (c & C & E); [intros; apply V | intros; apply CV |].
    rewrite Rmin_left, Rmax_right in C by lra.
    assert (m / 2 < F x c) by (apply FB; apply Rabs_le; lra).
    assert (m / 2 * h <= F x c * (y0 - (y0 - h))).
    { replace (y0 - (y0 - h)) with h by ring; apply Rmult_le_compat_r; lra. }
    apply Rabs_le_between in GB; lra. }
  destruct (IVT_gen (both p x) (y0 - h) (y0 + h) 0) as (y & Y & E); [exact CV | |].
  { rewrite Rmin_left, Rmax_right by lra; lra. }
  rewrite Rmin_left, Rmax_right in Y by lra.
  exists y; split; [exact E | apply Rabs_le; lra].
Qed.

Lemma both_opposite (p : list (list R)) (x y : R) : both (map (map Ropp) p) x y = - both p x y.
Proof.
  unfold both; induction p as [|c q IH]; simpl; [ring|]; rewrite IH, horner_opposite; ring.
Qed.

Lemma slope_opposite (p : list (list R)) (x y : R) :
  slope (map (fun c => horner c x) (map (map Ropp) p)) y = - slope (map (fun c => horner c x) p) y.
Proof.
  induction p as [|c q IH]; simpl; [ring|]; rewrite IH.
  change (both (map (map Ropp) q) x y + y * - slope (map (fun c => horner c x) q) y =
          - (both q x y + y * slope (map (fun c => horner c x) q) y)).
  rewrite both_opposite; ring.
Qed.

(** [f] is the relation, [y] the truncated series, [g] what remains of the relation over x^n. *)
Lemma branch (f : R -> R -> R) (y : R -> R) (p : list (list R)) (s g : list R) (n : nat) :
  (0 < n)%nat ->
  (forall x y, f x y = both p x y) -> (forall x, y x = horner s x) ->
  (forall x, f x (y x) = x ^ n * horner g x) ->
  slope (map (fun c => horner c 0) p) (horner s 0) <> 0 ->
  exists e k, 0 < e /\ 0 < k /\
    forall x, Rabs x < e -> exists z, f x z = 0 /\ Rabs (z - y x) <= k * Rabs x ^ n.
Proof.
  intros N F Y Z M.
  assert (Z' : forall x, both p x (horner s x) = x ^ n * horner g x) by (intros x; rewrite <- F, <- Y; apply Z).
  assert (B : exists e k, 0 < e /\ 0 < k /\
    forall x, Rabs x < e -> exists z, both p x z = 0 /\ Rabs (z - horner s x) <= k * Rabs x ^ n).
  { destruct (Rdichotomy _ _ M) as [L|L].
    - destruct (branch_up (map (map Ropp) p) s (map Ropp g) n N) as (e & k & E & K & H).
      + intros x; rewrite both_opposite, Z', horner_opposite; ring.
      + rewrite slope_opposite; lra.
      + exists e, k; split; [exact E | split; [exact K|]]; intros x X.
        destruct (H x X) as (z & V & W); exists z; rewrite both_opposite in V; split; [lra | exact W].
    - exact (branch_up p s g n N Z' L). }
  destruct B as (e & k & E & K & H); exists e, k; split; [exact E | split; [exact K|]]; intros x X.
  destruct (H x X) as (z & V & W); exists z; rewrite F, Y; auto.
Qed.

Lemma different (x v : R) : x = v -> v <> 0 -> x <> 0.
Proof. now intros ->. Qed.

(** ** Connected sets *)

(** The point that lies between two others. *)
Definition between (a b u : R) : R := a + u * (b - a).

Lemma between_positive (a b u : R) : 0 < a -> 0 < b -> 0 <= u <= 1 -> 0 < between a b u.
Proof. unfold between; nra. Qed.

Lemma between_start (a b : R) : between a b 0 = a.
Proof. unfold between; ring. Qed.

Lemma between_end (a b : R) : between a b 1 = b.
Proof. unfold between; ring. Qed.

Lemma between_continuous (a b u : R) : continuous (fun u => between a b u) u.
Proof. apply (ex_derive_continuous (fun u => between a b u)); unfold between; auto_derive; exact I. Qed.

Lemma quotient_of_continuous (f g : R -> R) (u : R) :
  continuous f u -> continuous g u -> g u <> 0 -> continuous (fun u => f u / g u) u.
Proof.
  intros F G N; apply (continuous_mult f (fun u => / g u)); [exact F|].
  apply continuous_comp; [exact G | now apply continuous_Rinv].
Qed.

Lemma power_of_continuous (f : R -> R) (n : nat) (u : R) : continuous f u -> continuous (fun u => f u ^ n) u.
Proof.
  intros F; induction n as [|n IH]; [apply continuous_const|]; simpl.
  now apply (continuous_mult f (fun u => f u ^ n)).
Qed.

(** Continuity by form; what divides is positive by form. *)
Ltac continuous_by_form :=
  lazymatch goal with
  | |- continuous (fun u => between _ _ u) _ => apply between_continuous
  | |- continuous (fun u => @?f u + @?g u) _ => apply (continuous_plus f g); continuous_by_form
  | |- continuous (fun u => @?f u - @?g u) _ => apply (continuous_minus f g); continuous_by_form
  | |- continuous (fun u => @?f u * @?g u) _ => apply (continuous_mult f g); continuous_by_form
  | |- continuous (fun u => - @?f u) _ => apply (continuous_opp f); continuous_by_form
  | |- continuous (fun u => @?f u / @?g u) _ =>
      apply (quotient_of_continuous f g); [continuous_by_form | continuous_by_form | cbn beta; divisor]
  | |- continuous (fun u => @?f u ^ ?n) _ => apply (power_of_continuous f n); continuous_by_form
  | |- continuous (fun _ => _) _ => apply continuous_const
  end.
