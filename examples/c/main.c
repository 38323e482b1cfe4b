/* The press in a control loop: a controller brings the crank to 60 revolutions a minute and holds it there while the ram works.
 *
 *     linkwright export c --output build examples/c/press.mech
 *     cc -std=c99 -O2 -Ibuild examples/c/main.c build/press.c -lm -o build/press && build/press
 */
#include "press.h"

#include <stdio.h>

#define TICK 1e-3
#define TICKS 3000
#define ASKED 6.283185307179586 /* rad/s */

static press_t plant;

int main(void)
{
    press_inputs_t inputs = {0.0};
    press_outputs_t outputs = {0.0, 0.0, 0.0};
    press_tick_t tick;
    double sum = 0.0;
    double worst = 0.0;
    int i;
    press_status_t status = press_init(&plant, NULL);

    for (i = 0; (i < TICKS) && (status == PRESS_OK); i++) {
        double error;

        (void)press_read_outputs(&plant, &inputs, &outputs);
        error = ASKED - outputs.speed;
        sum += error * TICK;
        inputs.torque = (150.0 * error) + (600.0 * sum);
        inputs.torque = (inputs.torque > 400.0) ? 400.0 : ((inputs.torque < -400.0) ? -400.0 : inputs.torque);
        status = press_step_rk4_corrected(&plant, &inputs, TICK, &tick);
        if ((i > 1000) && (((error < 0.0) ? -error : error) > worst)) {
            worst = (error < 0.0) ? -error : error;
        }
        if ((i % 250) == 0) {
            (void)printf("%6.3f s  %8.3f rad  %7.3f rad/s  stroke %.4f m  torque %7.2f N m\n", tick.time, outputs.angle,
                         outputs.speed, outputs.stroke, inputs.torque);
        }
    }
    if (status != PRESS_OK) {
        (void)printf("%s\n", press_status_text(status));
        return 1;
    }
    (void)printf("from one second on the speed is off by at most %.1f %%\n", 100.0 * worst / ASKED);
    return (worst < (0.1 * ASKED)) ? 0 : 1;
}
