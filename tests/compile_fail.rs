//! What does not fit does not compile, and says why.
//!
//! The messages are those of one compiler version, so the test is asked for by name: `cargo test --test compile_fail -- --ignored`.

#[test]
#[ignore = "the wording of compiler messages changes with the compiler"]
fn wrong_sizes_and_wrong_rungs_are_refused_with_a_message() {
    trybuild::TestCases::new().compile_fail("tests/compile_fail/*.rs");
}
