(** Limits, roots, growth and branches of functions that are polynomials or quotients of polynomials. *)

From Slipmode Require Export Tactics.

(** ** Polynomials as lists of coefficients, by ascending power *)

Fixpoint horner (p : list R) (x : R) : R :=
  match p with [] => 0 | c :: q => c + x * horner q x end.

Lemma horner_continuous (p : list R) (x : R) : continuous (horner p) x.
Proof.
  induction p as [|c q IH]; [apply continuous_const|].
  apply (continuous_plus (fun _ => c) (fun x => x * horner q x)); [apply continuous_const|].
  now apply (continuous_mult (fun x => x) (horner q)); [apply continuous_id|].
Qed.

(** ** Limits *)

Lemma quotient_continuous (n d : list R) :
  horner d 0 <> 0 -> continuous (fun x => horner n x / horner d x) 0.
Proof.
  intros H; apply (continuous_mult (horner n) (fun x => / horner d x)); [apply horner_continuous|].
  apply continuous_comp; [apply horner_continuous|].
  now apply continuous_Rinv.
Qed.

(** From above to 0. *)
Lemma limit_at_zero (f : R -> R) (n d : list R) (l : R) :
  (forall x, 0 < x -> f x = horner n x / horner d x) -> horner d 0 <> 0 ->
  l = horner n 0 / horner d 0 -> filterlim f (at_right 0) (locally l).
Proof.
  intros E D ->.
  apply filterlim_ext_loc with (f := fun x => horner n x / horner d x).
  - exists (mkposreal 1 Rlt_0_1); intros x _ H; symmetry; now apply E.
  - eapply filterlim_filter_le_1; [apply filter_le_within|]; now apply (quotient_continuous n d).
Qed.

(** To infinity, where the quotient is one of polynomials in 1/x. *)
Lemma limit_at_infinity (f : R -> R) (n d : list R) (l : R) :
  (forall x, 0 < x -> f x = horner n (/ x) / horner d (/ x)) -> horner d 0 <> 0 ->
  l = horner n 0 / horner d 0 -> filterlim f (Rbar_locally p_infty) (locally l).
Proof.
  intros E D ->.
  apply filterlim_ext_loc with (f := fun x => horner n (/ x) / horner d (/ x)).
  - exists 0; intros x H; symmetry; now apply E.
  - apply (filterlim_comp _ _ _ Rinv (fun y => horner n y / horner d y) _ (locally 0)).
    + apply (is_lim_inv (fun x => x) p_infty p_infty (is_lim_id p_infty)); discriminate.
    + now apply (quotient_continuous n d).
Qed.

(** ** Roots *)

Lemma horner_continuity (p : list R) : continuity (horner p).
Proof. intros x; apply continuity_pt_filterlim, horner_continuous. Qed.

Lemma root_inside (f : R -> R) (p : list R) (a b : R) :
  (forall s, f s = horner p s) -> a < b -> (0 < f a /\ f b < 0) \/ (f a < 0 /\ 0 < f b) ->
  exists s, a < s /\ s < b /\ f s = 0.
Proof.
  intros E H S.
  assert (N : forall s, f s = 0 -> a <= s <= b -> a < s /\ s < b /\ f s = 0).
  { intros s Z [[L|L] [M|M]]; try subst; try (repeat split; assumption); exfalso; lra. }
  destruct S as [[A B]|[A B]].
  - destruct (IVT (fun x => - horner p x) a b) as [s [I Z]]; try rewrite <- E; try lra.
    { apply continuity_opp, horner_continuity. }
    exists s; apply N; [rewrite E; lra | exact I].
  - destruct (IVT (horner p) a b) as [s [I Z]]; try rewrite <- E; try lra.
    { apply horner_continuity. }
    exists s; apply N; [rewrite E; exact Z | exact I].
Qed.

(** A polynomial keeps the sign of its leading coefficient far to the right. *)
Lemma leading (p : list R) : 0 < last p 0 -> exists m b, 0 < m /\ forall x, b < x -> m < horner p x.
Proof.
  induction p as [|c q IH]; [simpl; lra|]; intros H.
  destruct q as [|d q].
  - simpl in *; exists (c / 2), 0; split; [lra | intros; lra].
  - destruct (IH H) as (m & b & M & B).
    exists 1, (Rmax b (Rmax 1 ((1 - c) / m))); split; [lra|]; intros x X.
    assert (b < x) by (eapply Rle_lt_trans; [apply Rmax_l | exact X]).
    assert (R : Rmax 1 ((1 - c) / m) < x) by (eapply Rle_lt_trans; [apply Rmax_r | exact X]).
    assert (1 < x) by (eapply Rle_lt_trans; [apply Rmax_l | exact R]).
    assert (Q : (1 - c) / m < x) by (eapply Rle_lt_trans; [apply Rmax_r | exact R]).
    assert (1 - c < x * m).
    { apply (Rmult_lt_compat_r m) in Q; [|exact M]; replace ((1 - c) / m * m) with (1 - c) in Q by (field; lra); lra. }
    specialize (B x ltac:(assumption)).
    change (1 < c + x * horner (d :: q) x).
    assert (x * m < x * horner (d :: q) x) by (apply Rmult_lt_compat_l; lra); lra.
Qed.

Lemma last_opposite (p : list R) : last (map Ropp p) 0 = - last p 0.
Proof. induction p as [|c [|d q] IH]; simpl in *; lra. Qed.

Lemma horner_opposite (p : list R) (x : R) : horner (map Ropp p) x = - horner p x.
Proof. induction p as [|c q IH]; simpl; [lra|]; rewrite IH; lra. Qed.

(** Right of every bound there is a point at which a polynomial has the sign of its leading coefficient. *)
Lemma far (p : list R) (a : R) : 0 < last p 0 -> exists x, a < x /\ 0 < horner p x.
Proof.
  intros H; destruct (leading p H) as (m & b & M & B).
  exists (Rmax a b + 1); pose proof (Rmax_l a b); pose proof (Rmax_r a b).
  split; [lra|]; specialize (B (Rmax a b + 1)); lra.
Qed.

Lemma far_negative (p : list R) (a : R) : last p 0 < 0 -> exists x, a < x /\ horner p x < 0.
Proof.
  intros H; destruct (far (map Ropp p) a) as [x [X P]]; [rewrite last_opposite; lra|].
  exists x; rewrite horner_opposite in P; lra.
Qed.

Lemma root_above (f : R -> R) (p : list R) (a : R) :
  (forall s, f s = horner p s) -> (0 < f a /\ last p 0 < 0) \/ (f a < 0 /\ 0 < last p 0) ->
  exists s, a < s /\ f s = 0.
Proof.
  intros E [[A L]|[A L]].
  - destruct (far_negative p a L) as [b [B S]].
    destruct (root_inside f p a b E B) as (s & ? & ? & ?); [left; rewrite (E b); lra|]; eauto.
  - destruct (far p a L) as [b [B S]].
    destruct (root_inside f p a b E B) as (s & ? & ? & ?); [right; rewrite (E b); lra|]; eauto.
Qed.

(** [q] is the polynomial reflected at 0. *)
Lemma root_below (f : R -> R) (p q : list R) (b : R) :
  (forall s, f s = horner p s) -> (forall s, horner p (- s) = horner q s) ->
  (0 < f b /\ last q 0 < 0) \/ (f b < 0 /\ 0 < last q 0) -> exists s, s < b /\ f s = 0.
Proof.
  intros E Q S.
  destruct (root_above (fun s => f (- s)) q (- b)) as (s & L & Z).
  - intros s; rewrite E; apply Q.
  - rewrite Ropp_involutive; exact S.
  - exists (- s); split; [lra | exact Z].
Qed.

(** A polynomial whose values far to the left and far to the right have opposite signs. *)
Lemma root_anywhere (f : R -> R) (p q : list R) :
  (forall s, f s = horner p s) -> (forall s, horner p (- s) = horner q s) ->
  (0 < last q 0 /\ last p 0 < 0) \/ (last q 0 < 0 /\ 0 < last p 0) -> exists s, f s = 0.
Proof.
  intros E Q [[L H]|[L H]].
  - destruct (far_negative p 0 H) as [b [_ B]].
    destruct (root_below f p q b E Q) as (s & _ & Z); [right; rewrite (E b) | exists s]; auto.
  - destruct (far p 0 H) as [b [_ B]].
    destruct (root_below f p q b E Q) as (s & _ & Z); [left; rewrite (E b) | exists s]; auto.
Qed.

(** ** Growth *)

(** What vanishes at 0 and has a positive slope right of 0 is positive there. *)
Lemma growth (f g : R -> R) (x : R) :
  (forall y, is_derive f y (g y)) -> f 0 = 0 -> (forall y, 0 < y -> 0 < g y) -> 0 < x -> 0 < f x.
Proof.
  intros D Z G X.
  destruct (MVT_gen f 0 x g) as (c & C & E); try (intros; apply D).
  { intros y _; apply continuity_pt_filterlim, (ex_derive_continuous f); eexists; apply D. }
  rewrite Rmin_left, Rmax_right in C by lra.
  destruct (Req_dec c 0) as [->|N].
  - (* The mean value at 0 itself: take it again between x/2 and x. *)
    destruct (MVT_gen f 0 (x / 2) g) as (c & C1 & E1); try (intros; apply D).
    { intros y _; apply continuity_pt_filterlim, (ex_derive_continuous f); eexists; apply D. }
    destruct (MVT_gen f (x / 2) x g) as (d & C2 & E2); try (intros; apply D).
    { intros y _; apply continuity_pt_filterlim, (ex_derive_continuous f); eexists; apply D. }
    rewrite Rmin_left, Rmax_right in C1, C2 by lra.
    assert (0 < g d) by (apply G; lra).
    assert (0 <= g c).
    { destruct (Req_dec c 0) as [->|]; [|left; apply G; lra].
      destruct (Rle_lt_dec 0 (g 0)) as [|L]; [assumption|].
      exfalso; assert (0 < g d * (x - x / 2)) by (apply Rmult_lt_0_compat; lra). nra. }
    assert (0 < g d * (x - x / 2)) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= g c * (x / 2 - 0)) by (apply Rmult_le_pos; lra); lra.
  - assert (0 < g c * (x - 0)) by (apply Rmult_lt_0_compat; [apply G; lra | lra]); lra.
Qed.
