// A thread that the system wakes promptly although others compute.
#pragma once

namespace autoref::live {

// Asks the system to let the calling thread begin soon when it wakes, in exchange for shorter turns
// on the processor, and not to delay its timers. No privileges are needed. Systems that know
// nothing of it, such as Linux before 6.12, go on as before; so does a thread with a real-time
// policy. Threads and processes that the calling thread starts later inherit the short turns.
void be_prompt();

}  // namespace autoref::live
