Lemma growth_right (f g : R -> R) (x : R) :
  continuous f 0 -> (forall y, 0 < y -> is_derive f y (g y)) -> f 0 = 0 -> (forall y, 0 < y -> 0 < g y) -> 0 < x -> 0 < f x.
Proof.
  intros C D Z G X.
  assert (M : forall s t, 0 < s -> s < t -> f s < f t)
    by (intros s t S T; apply (rises f g); [ intros; apply D; lra | intros; apply G; lra | exact T ]).
  destruct (Rle_lt_dec 0 (f (x / 2))) as [P|N]; [ pose proof (M (x / 2) x ltac:(lra) ltac:(lra)); lra | exfalso ].
  destruct (C (fun v => f (x / 2) < v)) as [e E].
  - exists (mkposreal (- f (x / 2)) ltac:(lra)); intros v B.
    rewrite Z in B; apply Rabs_def2 in B; cbn in B; unfold minus, plus, opp in B; cbn in B; lra.
  - pose proof (cond_pos e); set (t := Rmin (x / 4) (e / 2)).
    assert (0 < t) by (unfold t; apply Rmin_glb_lt; lra).
    assert (t <= x / 4 /\ t <= e / 2) by (unfold t; split; [ apply Rmin_l | apply Rmin_r ]).
    assert (f (x / 2) < f t) by (apply E; apply Rabs_def1; unfold minus, plus, opp; cbn; lra).
    pose proof (M t (x / 2) ltac:(lra) ltac:(lra)); lra.
Qed.
