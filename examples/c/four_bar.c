/*
 * A user's own linkage, exported by suspension-c/examples/four_bar.rs: the rocker of a four-bar while
 * its crank turns.
 */
#include <stdio.h>
#include <stdlib.h>
#include "my_four_bar_f32.h"

static void check(susp_status status)
{
    if (status != SUSP_OK) {
        fprintf(stderr, "%s\n", susp_status_text(status));
        exit(EXIT_FAILURE);
    }
}

int main(void)
{
    my_four_bar_f32_points design;
    my_four_bar_f32_model model;
    my_four_bar_f32_motion motion;
    my_four_bar_f32_inputs inputs = {.rate = {.turn = 1}};
    my_four_bar_f32_point_rates points;
    my_four_bar_f32_measure_rates measures;

    check(my_four_bar_f32_design(&design));
    check(my_four_bar_f32_model_new(&model, sizeof model, &design, NULL));
    check(my_four_bar_f32_model_drives(&model, &design, &inputs.value));
    inputs.value.turn = 0.5f;
    check(my_four_bar_f32_assemble(&model, &inputs, &design, &motion, sizeof motion, NULL, NULL));
    for (int step = 0; step <= 1000; step++) {
        inputs.value.turn = 0.5f + 0.001f * (float)step;
        check(my_four_bar_f32_step(&model, &inputs, step == 0 ? 0 : 0.001f, &motion, NULL, NULL));
    }
    check(my_four_bar_f32_read_points(&model, &inputs, &motion, &points));
    check(my_four_bar_f32_read_measures(&model, &points, &measures));
    printf("%s %.6f rad, %.6f rad/s\n", my_four_bar_f32_measure_name(0),
            (double)measures.value.double_, (double)measures.rate.double_);
    return EXIT_SUCCESS;
}
