# A sweep in shards that share no folder, as on Kubernetes (docs/sweeps.md).
SHARDS = 7

rule merged:
    input: expand("shards/{shard}", shard=range(SHARDS))
    output: "classes.csv"
    shell: "mkdir -p blocks && cp shards/*/block-*.csv blocks && slipmode merge blocks --shards {SHARDS} -o {output}"

rule shard:
    input: "scene.toml"
    output: directory("shards/{shard}")
    threads: 1
    resources: runtime=60, mem_mb=100
    shell: "slipmode sweep {input} --shard {wildcards.shard}/{SHARDS} --out {output} --threads 1"
