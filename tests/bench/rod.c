/* SPDX-License-Identifier: LGPL-2.1-or-later
 *
 * The paper's experiment 1 in plain C: what a program costs that can do nothing
 * else. Linear cells of one size, backward Euler with the exact contact
 * pressure, the paper's first step, one row of CSV for each step; no energy
 * audit. The blocks of two unknowns to a node are eliminated from both ends.
 *
 *   cc -O2 -o rod tests/bench/rod.c -lm && ./rod CELLS STEPS STEP_SIZE FILE|-
 *
 * Prints the seconds of the steps, per step in us, and the last u(1).
 *
 * With theta = 10 + w, w(0) = 0, rates (w', v) and tau the step:
 *   (M + tau K) w' + a D v           = -K w - k 10 e_n
 *   -tau^2 a D^T w' + (M + (tau^2 + tau zeta) S) v = M v_0 - tau S u_0
 *                                      + tau a D^T (w_0 + 10) - tau p e_n,
 * K = S + k e_n e_n^T, and u(1) = u_free - chi p, eps p = u(1) - g > 0.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static const double a = 0.017, eps = 0.01, k = 1., zeta = 0.2, gap = 0.1;
static const double theta_A = 10.;

typedef struct
{
  double e[4]; /* times the neighbour that is eliminated before */
  double d[4]; /* inverse of the pivot */
  double s[4]; /* times the neighbour that is known before */
} Node;

static int    n, mid;
static double tau, h;
static Node  *nodes; /* 1 .. n at 0 .. n-1 */
static double left[4], right[4];

static double
seconds(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

static double *
array(int size)
{
  double *x = calloc(size, sizeof(double));
  if (!x)
    exit(1);
  return x;
}

static void
multiply(const double *x, const double *y, double *z)
{
  z[0] = x[0] * y[0] + x[1] * y[2];
  z[1] = x[0] * y[1] + x[1] * y[3];
  z[2] = x[2] * y[0] + x[3] * y[2];
  z[3] = x[2] * y[1] + x[3] * y[3];
}

static void
invert(const double *x, double *y)
{
  const double q = 1. / (x[0] * x[3] - x[1] * x[2]);
  y[0]           = q * x[3];
  y[1]           = -q * x[1];
  y[2]           = -q * x[2];
  y[3]           = q * x[0];
}

/* Rows of a node: with its left neighbour, itself, its right neighbour. */
static void
blocks(int i, double *lower, double *diagonal, double *upper)
{
  const int    is_last = i == n - 1;
  const double m = h / 6., s = 1. / h, q = tau * tau + tau * zeta;
  const double D = 0.5 * a, T = 0.5 * a * tau * tau;
  const double off_heat = m - tau * s, off_momentum = m - q * s;
  lower[0] = upper[0] = off_heat;
  lower[3] = upper[3] = off_momentum;
  lower[1]            = -D; /* (D v)_i = (v_{i+1} - v_{i-1}) / 2 */
  upper[1]            = D;
  lower[2]            = -T; /* (D^T w)_i = (w_{i-1} - w_{i+1}) / 2 */
  upper[2]            = T;
  diagonal[0] = (is_last ? 1. : 2.) * (2. * m + tau * s) + (is_last ? tau * k : 0.);
  diagonal[3] = (is_last ? 1. : 2.) * (2. * m + q * s);
  diagonal[1] = is_last ? D : 0.;
  diagonal[2] = is_last ? -T : 0.;
}

static void
eliminate(int before, const double *to_before, const double *from_before,
          double *factor, double *d)
{
  double change[4];
  multiply(to_before, nodes[before].d, factor);
  multiply(factor, from_before, change);
  for (int j = 0; j < 4; ++j)
    d[j] -= change[j];
}

static void
factorize(void)
{
  double l[4], d[4], u[4], x[4], y[4], of_before[4];
  nodes = calloc(n, sizeof(Node));
  mid   = n / 2;
  for (int i = 0; i < mid; ++i)
    {
      blocks(i, l, d, u);
      if (i > 0)
        {
          blocks(i - 1, x, y, of_before);
          eliminate(i - 1, l, of_before, nodes[i].e, d);
        }
      invert(d, nodes[i].d);
      multiply(nodes[i].d, u, nodes[i].s);
    }
  for (int i = n - 1; i > mid; --i)
    {
      blocks(i, l, d, u);
      if (i < n - 1)
        {
          blocks(i + 1, of_before, y, x);
          eliminate(i + 1, u, of_before, nodes[i].e, d);
        }
      invert(d, nodes[i].d);
      multiply(nodes[i].d, l, nodes[i].s);
    }
  blocks(mid, l, d, u);
  if (mid > 0)
    {
      blocks(mid - 1, x, y, of_before);
      eliminate(mid - 1, l, of_before, left, d);
    }
  if (mid < n - 1)
    {
      blocks(mid + 1, of_before, y, x);
      eliminate(mid + 1, u, of_before, right, d);
    }
  invert(d, nodes[mid].d);
}

#define SUBTRACT(x0, x1, f, y0, y1)     \
  {                                     \
    x0 -= f[0] * (y0) + f[1] * (y1);    \
    x1 -= f[2] * (y0) + f[3] * (y1);    \
  }

/* b becomes the solution; two values to a node. */
static void
solve(double *b)
{
  int    i = 1, j = n - 2;
  double p = b[0], q = b[1], r = b[2 * n - 2], s = b[2 * n - 1];
  for (; i < mid || j > mid; ++i, --j)
    {
      if (i < mid)
        {
          SUBTRACT(b[2 * i], b[2 * i + 1], nodes[i].e, p, q);
          p = b[2 * i];
          q = b[2 * i + 1];
        }
      if (j > mid)
        {
          SUBTRACT(b[2 * j], b[2 * j + 1], nodes[j].e, r, s);
          r = b[2 * j];
          s = b[2 * j + 1];
        }
    }
  double x = b[2 * mid], y = b[2 * mid + 1];
  if (mid > 0)
    SUBTRACT(x, y, left, p, q);
  if (mid < n - 1)
    SUBTRACT(x, y, right, r, s);
  const double *d = nodes[mid].d;
  p = r = b[2 * mid] = d[0] * x + d[1] * y;
  q = s = b[2 * mid + 1] = d[2] * x + d[3] * y;
  for (i = mid - 1, j = mid + 1; i >= 0 || j < n; --i, ++j)
    {
      if (i >= 0)
        {
          d = nodes[i].d;
          x = d[0] * b[2 * i] + d[1] * b[2 * i + 1];
          y = d[2] * b[2 * i] + d[3] * b[2 * i + 1];
          SUBTRACT(x, y, nodes[i].s, p, q);
          b[2 * i] = p = x;
          b[2 * i + 1] = q = y;
        }
      if (j < n)
        {
          d = nodes[j].d;
          x = d[0] * b[2 * j] + d[1] * b[2 * j + 1];
          y = d[2] * b[2 * j] + d[3] * b[2 * j + 1];
          SUBTRACT(x, y, nodes[j].s, r, s);
          b[2 * j] = r = x;
          b[2 * j + 1] = s = y;
        }
    }
}

/* Right-hand side for values at 0 .. n, without contact. */
static void
load(const double *w, const double *u, const double *v, double *b)
{
  const double m = h / 6., s = 1. / h;
  for (int i = 1; i < n; ++i)
    {
      b[2 * i - 2] = -s * ((w[i] - w[i - 1]) + (w[i] - w[i + 1]));
      b[2 * i - 1] = m * (v[i - 1] + 4. * v[i] + v[i + 1]) -
                     tau * s * ((u[i] - u[i - 1]) + (u[i] - u[i + 1])) +
                     0.5 * tau * a * (w[i - 1] - w[i + 1]);
    }
  b[2 * n - 2] = -s * (w[n] - w[n - 1]) - k * (w[n] + theta_A);
  b[2 * n - 1] = m * (v[n - 1] + 2. * v[n]) - tau * s * (u[n] - u[n - 1]) +
                 tau * a * (0.5 * (w[n - 1] + w[n]) + theta_A);
}

/* The first step: u moves with its velocity, then heat alone (Thomas). */
static void
first_step(double *w, double *u, const double *v)
{
  const double m = h / 6., s = 1. / h, off = m - tau * s;
  double      *d = array(n + 1), *b = array(n + 1);
  for (int i = 1; i <= n; ++i)
    {
      const int is_last = i == n;
      d[i] = (is_last ? 1. : 2.) * (2. * m + tau * s) + (is_last ? tau * k : 0.);
      b[i] = is_last ?
               -s * (w[n] - w[n - 1]) - k * (w[n] + theta_A) -
                 0.5 * a * (v[n] - v[n - 1]) :
               -s * ((w[i] - w[i - 1]) + (w[i] - w[i + 1])) -
                 0.5 * a * (v[i + 1] - v[i - 1]);
      if (i > 1)
        {
          const double f = off / d[i - 1];
          d[i] -= f * off;
          b[i] -= f * b[i - 1];
        }
    }
  for (int i = n; i >= 1; --i)
    b[i] = (b[i] - (i < n ? off * b[i + 1] : 0.)) / d[i];
  for (int i = 1; i <= n; ++i)
    {
      w[i] += tau * b[i];
      u[i] += tau * v[i];
    }
  free(d);
  free(b);
}

int
main(int argc, char **argv)
{
  if (argc != 5)
    {
      fprintf(stderr, "usage: rod CELLS STEPS STEP_SIZE FILE|-\n");
      return 2;
    }
  n                   = atoi(argv[1]);
  const int n_steps   = atoi(argv[2]);
  tau                 = atof(argv[3]);
  h                   = 1. / n;
  FILE         *file  = argv[4][0] == '-' ? NULL : fopen(argv[4], "w");
  const double  pi    = acos(-1.);
  double       *w = array(n + 1), *u = array(n + 1), *v = array(n + 1);
  double       *b = array(2 * n), *response = array(2 * n);
  for (int i = 1; i <= n; ++i)
    {
      const double x = i * h;
      w[i] = theta_A * (cos(2. * pi * x) - sin(0.5 * pi * x)) - theta_A;
      v[i] = 20. * x * (x - 1.) * (x - 1.);
    }
  factorize();
  response[2 * n - 1] = tau;
  solve(response);
  const double chi = tau * response[2 * n - 1];

  const double start = seconds();
  for (int step = 1; step <= n_steps; ++step)
    {
      double p = 0.;
      if (step == 1)
        {
          first_step(w, u, v);
          p = fmax(0., u[n] - gap) / eps;
        }
      else
        {
          load(w, u, v, b);
          solve(b);
          p = fmax(0., u[n] + tau * b[2 * n - 1] - gap) / (eps + chi);
          if (p > 0.)
            for (int i = 0; i < 2 * n; ++i)
              b[i] -= p * response[i];
          for (int i = 1; i <= n; ++i)
            {
              w[i] += tau * b[2 * i - 2];
              v[i] = b[2 * i - 1];
              u[i] += tau * v[i];
            }
        }
      if (file)
        fprintf(file,
                "%.6g,%.14g,%.14g,%.14g,%.14g\n",
                step * tau,
                u[n],
                u[n / 2],
                v[n],
                -p);
    }
  if (file)
    fclose(file);
  const double loop = seconds() - start;
  printf("loop_s=%.6f us_per_step=%.4f u_end=%.15g\n",
         loop,
         1e6 * loop / n_steps,
         u[n]);
  return 0;
}
