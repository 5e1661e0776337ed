/*
 * A double wishbone with a pushrod, from the text of its listing: camber, and the motion ratio of the damper,
 * over the travel of the wheel.
 *
 *     listing ../../suspension-core/src/linkages/double_wishbone_pushrod.linkage
 *
 * The last column is a checksum of the bits of everything computed so far:
 * suspension-c/examples/listing.rs, with the same listing compiled, prints the same.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "suspension_listing.h"

enum { STEPS = 12 };

static void fail(const char *what, susp_status status, const char *culprit)
{
    fprintf(stderr, "%s: %s (%s)\n", what, susp_status_text(status), culprit != NULL ? culprit : "-");
    exit(EXIT_FAILURE);
}

/* Ends the program if a call failed. */
static void check(susp_status status, const char *what)
{
    if (status != SUSP_OK)
        fail(what, status, NULL);
}

/* Adds bytes to an FNV-1a checksum. */
static uint64_t checksum = 0xcbf29ce484222325u;

static void add_to_checksum(const double *numbers, size_t count)
{
    const unsigned char *byte = (const unsigned char *)numbers;
    for (count *= sizeof *numbers; count > 0; byte++, count--)
        checksum = (checksum ^ *byte) * 0x100000001b3u;
}

static double *numbers(size_t count)
{
    double *memory = calloc(count, sizeof *memory);
    if (memory == NULL)
        fail("memory", SUSP_ERROR_NULL, NULL);
    return memory;
}

static size_t count_of(const susp_listing *listing, susp_kind kind)
{
    size_t count;
    check(susp_listing_count(listing, kind, &count), "counting");
    return count;
}

static size_t number_of(const susp_listing *listing, susp_kind kind, const char *name)
{
    size_t index;
    susp_status status = susp_listing_find(listing, kind, name, &index);
    if (status != SUSP_OK)
        fail("looking up", status, name);
    return index;
}

/* Parses the listing in a file and prints its mistakes. */
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
    if (status == SUSP_ERROR_LISTING) {
        fprintf(stderr, "%s\n", message);
        exit(EXIT_FAILURE);
    }
    check(status, "reading the listing");
    return listing;
}

/* The points that the listing states, except one that this program states itself. */
static susp_corner *place(const susp_listing *listing)
{
    susp_corner *corner;
    susp_f64_failure failure = {.culprit = NULL};
    size_t count = 3 * count_of(listing, SUSP_POINT);
    double *points = numbers(count);
    check(susp_listing_design(listing, points, count), "the design");
    points[3 * number_of(listing, SUSP_POINT, "damper_inner") + 1] = 0.11;
    susp_status status = susp_corner_new(listing, points, count, &corner, &failure);
    if (status != SUSP_OK)
        fail("the points", status, failure.culprit);
    free(points);
    return corner;
}

int main(int count, char **arguments)
{
    const double degrees = 57.29577951308232;
    if (count != 2) {
        fprintf(stderr, "usage: %s FILE.linkage\n", arguments[0]);
        return EXIT_FAILURE;
    }
    susp_listing *listing = read_listing(arguments[1]);
    susp_corner *corner = place(listing);
    const size_t point_count = 9 * count_of(listing, SUSP_POINT);
    const size_t measure_count = 3 * count_of(listing, SUSP_MEASURE);
    const size_t drive_count = count_of(listing, SUSP_DRIVE);
    const size_t bump = number_of(listing, SUSP_DRIVE, "bump");
    const size_t damper = number_of(listing, SUSP_MEASURE, "damper");
    double *points = numbers(point_count), *measures = numbers(measure_count);
    double *drives = numbers(3 * drive_count), *change = numbers(drive_count);
    susp_f64_failure failure = {.culprit = NULL};

    check(susp_corner_drives(corner, drives, drive_count), "the drives");
    change[bump] = 1;
    const double height = drives[bump];
    puts("    bump   camber  damper per bump");
    puts("       m      deg");
    for (int step = 0; step <= STEPS; step++) {
        susp_f64_wheel wheel;
        /* One second per row, at a constant rate; the first step computes the rates. */
        const double travel = 0.01 * (step - STEPS / 2);
        drives[bump] = height + travel;
        drives[drive_count + bump] = 0.01;
        susp_status status = susp_corner_advance(corner, drives, 3 * drive_count, 1, NULL, &failure);
        if (status != SUSP_OK)
            fail("the step", status, failure.culprit);
        check(susp_corner_read_points(corner, points, point_count), "reading the points");
        add_to_checksum(points, point_count);
        status = susp_corner_read_derivatives(
            corner, change, drive_count, points, point_count, measures, measure_count, &failure);
        if (status != SUSP_OK)
            fail("the motion ratio", status, failure.culprit);
        add_to_checksum(points, point_count);
        add_to_checksum(measures, measure_count);
        check(susp_corner_read_wheel(corner, &wheel), "reading the wheel");
        add_to_checksum(&wheel.camber, 1);
        printf("%8.3f %8.4f %10.6f  %016llx\n", travel, wheel.camber * degrees, measures[measure_count / 3 + damper],
            (unsigned long long)checksum);
    }
    free(points);
    free(measures);
    free(drives);
    free(change);
    check(susp_corner_destroy(corner), "the end of the suspension");
    check(susp_listing_destroy(listing), "the end of the listing");
    return EXIT_SUCCESS;
}
