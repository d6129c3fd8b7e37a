// The precompiled header of the tests needs a target of its own to be built in.
