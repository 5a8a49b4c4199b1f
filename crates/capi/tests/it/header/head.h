// carom: elastic impact with friction, for C and C++ (Fortran: see contact.f90).
//
// Made from the Rust sources of carom-capi; not to be edited.
//
// Calls. Every function that can fail returns a carom_status. What is wrong it writes as a sentence into the
// `text` of a carom_error, which may always be null. A failed call leaves the data of the caller as they
// were; a call on many contacts keeps those before the one that failed. The library keeps nothing between
// calls, so that different threads may work on different data.
//
// Data. Structures are plain data that may be copied as bytes. A carom_law is made once and freed at the end; it is the
// only memory that the library allocates. Memories (carom_touch, carom_contact) belong to the caller: zero bytes at
// first, afterwards written by this build of the library only. Other bytes give an error status or meaningless numbers.
// The size of a touch is told by its law. Units are SI, or any consistent set.
//
// Pointers. A pointer must be null or point to an object of its type; where the function names a number of
// entries, to the first of so many. The objects that a call writes must overlap no other. A null pointer
// where none is allowed gives CAROM_STATUS_NULL_POINTER, one that is not aligned CAROM_STATUS_MISALIGNED.
