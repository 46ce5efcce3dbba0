//! What a page shows when it is opened: pieces of HTML in one compressed block of the page.
//!
//! Long tables and proofs would make the page five times as large. Its script unpacks them; without scripts, links lead to the
//! files beside the page that have the same.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

/// The pieces of a page, each known by its place.
#[derive(Debug, Default)]
pub(super) struct Packed {
    pieces: Vec<String>,
}

impl Packed {
    /// Keeps a piece of HTML. Returns its place, which the page's script looks for.
    pub fn keep(&mut self, html: String) -> usize {
        self.pieces.push(html);
        self.pieces.len() - 1
    }

    /// The block: the list of the pieces as JSON, deflated with the header of zlib, in base64. Empty without pieces.
    ///
    /// The compressor is written in Rust without instructions of one processor: it gives the same bytes on all machines.
    pub fn block(&self) -> String {
        if self.pieces.is_empty() {
            return String::new();
        }
        let list = serde_json::Value::from(self.pieces.clone()).to_string();
        BASE64_STANDARD.encode(miniz_oxide::deflate::compress_to_vec_zlib(list.as_bytes(), STRONGEST))
    }
}

/// The level of compression that takes longest.
const STRONGEST: u8 = 10;

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// The pieces that a page has packed.
    pub fn pieces_of(page: &str) -> Vec<String> {
        let block = page.split("<template id=\"packed\">").nth(1).and_then(|rest| rest.split('<').next());
        let deflated = BASE64_STANDARD.decode(block.unwrap_or_default()).unwrap();
        serde_json::from_slice(&miniz_oxide::inflate::decompress_to_vec_zlib(&deflated).unwrap()).unwrap()
    }

    #[test]
    fn a_block_has_the_pieces_in_their_order() {
        let mut packed = Packed::default();
        assert_eq!(packed.block(), "");
        let pieces = ["<p>η ≥ 0</p>", "\"</script>\""];
        assert_eq!(pieces.map(|piece| packed.keep(piece.into())), [0, 1]);
        assert_eq!(pieces_of(&format!("<template id=\"packed\">{}</template>", packed.block())), pieces);
    }
}
