// carom: elastic impact with friction, for C and C++ (Fortran: see contact.f90).
//
// Made from the Rust sources of carom-capi; not to be edited.
//
// Calls. Every function that can fail returns a carom_status. What is wrong it writes as a sentence into the
// `text` of a carom_error, which may always be null. A failed call leaves the data of the caller as they
// were; a call on many contacts keeps those before the one that failed. The library keeps nothing between
// calls, so that different threads may work on different data.
//
// Data. All structures are plain data that may be copied as bytes. Constants (carom_pair, carom_grains) are
// made once. Memories (carom_contact, carom_touch, carom_ring_touch) belong to the caller. A memory must be
// zero bytes at first; afterwards only this build of the library may write it. Other bytes give an error
// status or meaningless numbers. Units are SI, or any consistent set.
//
// Pointers. A pointer must be null or point to an object of its type; where the function names a number of
// entries, to the first of so many. The objects that a call writes must overlap no other. A null pointer
// where none is allowed gives CAROM_STATUS_NULL_POINTER, one that is not aligned CAROM_STATUS_MISALIGNED.
