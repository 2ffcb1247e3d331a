use std::path::PathBuf;

/// Why a figure was not drawn.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The data or a range of the figure is not fit for it.
    #[error(transparent)]
    Input(#[from] crate::Error),
    /// A file name that ends in neither `.svg` nor `.png`.
    #[error("{} ends in neither .svg nor .png", .0.display())]
    Extension(PathBuf),
    /// The backend refused to draw.
    #[error("the figure could not be drawn: {0}")]
    Backend(String),
    /// The file was not written.
    #[error("{} was not written: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What went wrong.
        source: std::io::Error,
    },
}

impl Error {
    pub(super) fn backend(error: impl std::error::Error) -> Self {
        Error::Backend(error.to_string())
    }
}
