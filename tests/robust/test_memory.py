"""Under a memory limit a run is right or refused with a message; it never hangs and never ends without a word."""

from robust import PROGRAM, PUNCH, RESULTS, RoughWorld, cells, limited, main, on_ranks

MEGABYTES = (145, 150, 160, 175, 250, 300, 400, 500, 600, 650, 700, 900)
# By the program, and by the dynamic linker where not even the libraries fit.
REASONS = {2: ("more memory than the process may use", "does not fit into memory", "too little memory",
               "are available: use coarser meshes"),
           127: ("error while loading shared libraries",)}


def under(megabytes, *arguments):
    return limited("as", megabytes << 20, PROGRAM, "-q", "-i", PUNCH, *arguments)


class MemoryLimits(RoughWorld):
    def outcome(self, *command):
        done = self.run_command(*command)
        self.assertIn(done.returncode, (0, *REASONS), done.stderr)
        if done.returncode != 0:
            self.assertTrue(any(reason in done.stderr for reason in REASONS[done.returncode]), done.stderr)
        self.assertEqual(self.files(), RESULTS if done.returncode == 0 else [])
        for name in self.files():
            (self.folder / name).unlink()
        return done.returncode

    def test_one_process(self):
        codes = [self.outcome(*under(megabytes, *cells(40))) for megabytes in MEGABYTES]
        self.assertIn(2, codes)
        self.assertEqual(codes[-1], 0)

    def test_a_scene_that_cannot_fit_is_refused_before_it_is_assembled(self):
        done = self.run_command(*under(600, *cells(300)))
        self.assert_refused(done, "dofs need about ", "(ulimit -v) are available: use coarser meshes, order 1, or Multigrid",
                            "nothing was computed")

    def test_threads_find_their_memory(self):
        """Two bodies are factored at once, each thread with a buffer of OpenBLAS."""
        for threads in (1, 2, 4):
            codes = {self.outcome("env", f"OMP_NUM_THREADS={threads}", *under(megabytes, *cells(40)))
                     for megabytes in (700, 2500)}
            self.assertIn(0, codes)

    def test_two_ranks(self):
        for megabytes in (400, 2000):
            self.outcome(*on_ranks(2, *under(megabytes)))


if __name__ == "__main__":
    main()
