// SPDX-License-Identifier: MIT
// How a program that searches and draws uses the heap.
#pragma once

namespace ballpit {

/// Call once, first in main. Memory that is freed stays with the program, so that the system need not map and clear it
/// again: frames take megabytes, and this saves a twentieth of their time. The heap begins with a gigabyte of addresses
/// (64 MB if they are limited) in huge pages, where the system has them; only what is used takes memory. Each page is
/// mapped at once when it is first used, which takes a quarter of the time: the first search of a process takes 1.1 to
/// 1.9 times as long as a later one (medians of runs). And kernels that read neighbours, which lie a layer of
/// cells apart in memory, wait less often for the address of a page.
void set_up_heap();

}  // namespace ballpit
