//! Tells the program's build where these sources are; the program states a digest of them.

fn main() {
    println!("cargo:root={}", env!("CARGO_MANIFEST_DIR"));
    println!("cargo:rerun-if-changed=build.rs");
}
