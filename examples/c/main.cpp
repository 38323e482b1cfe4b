// The same loop in C++ with the class of press.hpp.
//
//     linkwright export c --output build examples/c/press.mech
//     cc -std=c99 -O2 -c build/press.c -o build/press.o
//     c++ -std=c++11 -O2 -Ibuild examples/c/main.cpp build/press.o -lm -o build/press_cpp && build/press_cpp
#include "press.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

int main()
{
    const double tick = 1e-3, asked = 6.283185307179586;
    linkwright::Press press;
    linkwright::Press::Inputs inputs = {0.0};
    linkwright::Press::Outputs outputs;
    double sum = 0.0, worst = 0.0;

    for (int i = 0; i < 3000; ++i) {
        (void)press.read_outputs(inputs, outputs);
        const double error = asked - outputs.speed;
        sum += error * tick;
        inputs.torque = std::max(-400.0, std::min(400.0, 150.0 * error + 600.0 * sum));
        const linkwright::Press::Status status = press.step_rk4_corrected(inputs, tick);
        if (status != PRESS_OK) {
            std::printf("%s\n", linkwright::Press::text(status));
            return 1;
        }
        if (press.time() > 1.0) {
            worst = std::max(worst, std::fabs(error));
        }
    }
    std::printf("from one second on the speed is off by at most %.1f %%\n", 100.0 * worst / asked);
    return worst < 0.1 * asked ? 0 : 1;
}
