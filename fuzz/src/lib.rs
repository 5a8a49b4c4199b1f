//! What the targets share.

mod bytes;
mod folder;

pub use bytes::Bytes;
pub use folder::Folder;
