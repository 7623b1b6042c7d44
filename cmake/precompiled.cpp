// Compiles precompiled.hpp for the other targets.
