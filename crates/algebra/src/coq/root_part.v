Lemma root_part_lt (e o t : R) : 0 <= t -> 0 < e -> 0 < e ^ 2 - o ^ 2 * t -> 0 < e + o * sqrt t.
Proof. intros T E N; pose proof (sqrt_sqrt t T); destruct (Rlt_or_le 0 (e + o * sqrt t)); [assumption | nra]. Qed.

Lemma root_part_le (e o t : R) : 0 <= t -> 0 <= e -> 0 <= e ^ 2 - o ^ 2 * t -> 0 <= e + o * sqrt t.
Proof. intros T E N; pose proof (sqrt_sqrt t T); destruct (Rle_or_lt 0 (e + o * sqrt t)); [assumption | nra]. Qed.

Lemma root_part_other_lt (e o t : R) : 0 <= t -> 0 < o -> 0 < o ^ 2 * t - e ^ 2 -> 0 < e + o * sqrt t.
Proof.
  intros T O N; pose proof (sqrt_sqrt t T); pose proof (sqrt_pos t); pose proof (Rmult_le_pos o (sqrt t) ltac:(lra) ltac:(assumption)).
  destruct (Rlt_or_le 0 (e + o * sqrt t)); [assumption | nra].
Qed.

Lemma root_part_other_le (e o t : R) : 0 <= t -> 0 <= o -> 0 <= o ^ 2 * t - e ^ 2 -> 0 <= e + o * sqrt t.
Proof.
  intros T O N; pose proof (sqrt_sqrt t T); pose proof (sqrt_pos t); pose proof (Rmult_le_pos o (sqrt t) O ltac:(assumption)).
  destruct (Rle_or_lt 0 (e + o * sqrt t)); [assumption | nra].
Qed.
