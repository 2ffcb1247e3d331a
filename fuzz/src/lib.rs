//! The attacks of `tests/hostile`, for the fuzz targets.

#[path = "../../tests/hostile/driver/mod.rs"]
pub mod driver;
