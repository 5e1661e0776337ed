/*
 * A steered axle, from the text of its listing, one wheel up and the other down: camber, toe and kingpin angle of
 * each wheel, by its name.
 *
 *     axle ../../suspension-core/src/linkages/steered_axle.linkage
 */
#include <stdio.h>
#include <stdlib.h>

#include "suspension_listing.h"

enum { MOST_POINTS = 64, DRIVES = 3 };

/* Ends the program if a call failed. */
static void check(susp_status status, const char *what)
{
    if (status == SUSP_OK)
        return;
    fprintf(stderr, "%s: %s\n", what, susp_status_text(status));
    exit(EXIT_FAILURE);
}

static susp_listing *read_listing(const char *path)
{
    static char text[65536], message[4096];
    susp_listing *listing;
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        perror(path);
        exit(EXIT_FAILURE);
    }
    size_t length = fread(text, 1, sizeof text, file);
    fclose(file);
    susp_status status = susp_listing_parse(text, length, &listing, message, sizeof message, NULL);
    if (status == SUSP_ERROR_LISTING)
        fprintf(stderr, "%s\n", message);
    check(status, "reading the listing");
    return listing;
}

/* Moves a drive of the axle away from the design position. */
static void move(const susp_listing *listing, double *drives, const char *name, double by)
{
    size_t drive;
    check(susp_listing_find(listing, SUSP_DRIVE, name, &drive), name);
    drives[drive] += by;
}

int main(int count, char **arguments)
{
    const double degrees = 57.29577951308232;
    double points[3 * MOST_POINTS], drives[3 * DRIVES] = {0};
    susp_corner *corner;
    susp_f64_wheel wheel;
    susp_f64_kingpin kingpin;
    size_t point_count, wheel_count;
    if (count != 2) {
        fprintf(stderr, "usage: %s FILE.linkage\n", arguments[0]);
        return EXIT_FAILURE;
    }
    susp_listing *listing = read_listing(arguments[1]);
    check(susp_listing_count(listing, SUSP_POINT, &point_count), "counting the points");
    check(susp_listing_count(listing, SUSP_WHEEL, &wheel_count), "counting the wheels");
    if (point_count > MOST_POINTS)
        check(SUSP_ERROR_SIZE, "the points");
    check(susp_listing_design(listing, points, 3 * point_count), "the design");
    check(susp_corner_new(listing, points, 3 * point_count, &corner, NULL), "the points");
    check(susp_corner_drives(corner, drives, DRIVES), "the drives");
    move(listing, drives, "bump_left", 0.03);
    move(listing, drives, "bump_right", -0.02);
    move(listing, drives, "steer", 0.01);
    check(susp_corner_step(corner, drives, 3 * DRIVES, 0.5, NULL, NULL), "the step");

    puts("left wheel 30 mm up, right wheel 20 mm down, rack 10 mm to the left:");
    puts("  wheel    camber       toe   kingpin");
    puts("              deg       deg       deg");
    for (size_t index = 0; index < wheel_count; index++) {
        check(susp_corner_read_wheel_at(corner, index, &wheel), "reading a wheel");
        check(susp_corner_read_kingpin_at(corner, index, &kingpin), "reading a kingpin");
        printf("%7s %9.5f %9.5f %9.5f\n", susp_listing_name(listing, SUSP_WHEEL, index), wheel.camber * degrees,
            wheel.toe * degrees, kingpin.angle * degrees);
    }
    /* There is no third wheel. */
    if (susp_corner_read_wheel_at(corner, wheel_count, &wheel) != SUSP_ERROR_ABSENT
        || susp_listing_name(listing, SUSP_WHEEL, wheel_count) != NULL)
        return EXIT_FAILURE;
    check(susp_corner_destroy(corner), "the end of the axle");
    check(susp_listing_destroy(listing), "the end of the listing");
    return EXIT_SUCCESS;
}
