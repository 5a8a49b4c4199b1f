//! carom: carom.
