//! What a scene needs, planned and computed: pure, and the same bytes on any number of threads.
