#!/usr/bin/python3
"""Draws the model of weak scaling in docs/scaling.md: time of an iteration and memory of a rank up to 10 000 ranks.

    /usr/bin/python3 docs/pictures/scaling.py [FOLDER] [--latency 2e-6] [--bandwidth 5e9] [--seconds 0.05]

Latency in seconds a message, bandwidth in bytes a second and rank, seconds of arithmetic an iteration for the dofs of a
rank. Counts and bytes are those that docs/scaling.md lists. Needs python3-matplotlib; prints what the page's table has.
"""
import argparse
import math
import pathlib

# Of the ledger on 8 ranks with 109 000 dofs each, an iteration and rank: halo messages and bytes / cycles / ranks.
RANKS, DOFS = 8, 109_000
MESSAGES, BYTES = 290, 919e3
SUMS = 4  # of one number over all ranks, an iteration of conjugate gradients
LEVEL_PRODUCTS, MOST_NEIGHBOURS, COARSENING = 10, 26, 27
# Bytes of a rank: libraries, per dof of its own rows, per dof of the whole scene.
LIBRARIES, OWN, REPLICATED = 98e6, 1150.0, 45.0
MEMORY = 4 * 2.0**30  # of a rank


def neighbours(ranks):
    """Share of the neighbours that a rank inside of ranks in a cube has: none alone, all of them in the limit."""
    return 1.0 - ranks ** (-1.0 / 3.0)


def messages(ranks):
    """On the levels that there were, and ten products and transfers on each further one, with all neighbours."""
    more = max(0.0, math.log(ranks / RANKS, COARSENING))
    return MESSAGES * neighbours(ranks) / neighbours(RANKS) + LEVEL_PRODUCTS * MOST_NEIGHBOURS * more


def volume(ranks):
    return BYTES * neighbours(ranks) / neighbours(RANKS)


def seconds(ranks, given):
    """Arithmetic, messages, bytes and sums of an iteration."""
    tree = 2.0 * math.log2(ranks) if ranks > 1 else 0.0
    return (given.seconds, messages(ranks) * given.latency, volume(ranks) / given.bandwidth,
            SUMS * tree * given.latency)


def memory(ranks):
    return LIBRARIES + OWN * DOFS + REPLICATED * DOFS * ranks


def draw(folder, given):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    ranks = [2.0 ** (k / 4.0) for k in range(0, 54)] + [1e4]
    parts = list(zip(*(seconds(r, given) for r in ranks)))
    figure, (time, room) = plt.subplots(1, 2, figsize=(10, 4))
    time.stackplot(ranks, [[1e3 * s for s in part] for part in parts],
                   labels=("arithmetic", "messages", "bytes", "sums over all ranks"))
    time.set(xscale="log", xlabel="ranks", ylabel="ms an iteration", title=f"{DOFS:,} dofs a rank".replace(",", " "))
    time.legend(loc="center")
    room.loglog(ranks, [memory(r) / 2.0**30 for r in ranks], label="a rank")
    room.loglog(ranks, [REPLICATED * DOFS * r / 2.0**30 for r in ranks], "--", label="of it replicated")
    room.axhline(MEMORY / 2.0**30, color="grey", label="4 GiB")
    room.set(xlabel="ranks", ylabel="GiB", title="memory")
    room.legend()
    figure.tight_layout()
    figure.savefig(pathlib.Path(folder) / "scaling.png", dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", default=pathlib.Path(__file__).parent)
    parser.add_argument("--latency", type=float, default=2e-6)
    parser.add_argument("--bandwidth", type=float, default=5e9)
    parser.add_argument("--seconds", type=float, default=0.05)
    given = parser.parse_args()
    print("ranks  messages  kB  ms: arithmetic messages bytes sums  efficiency  GiB a rank")
    for ranks in (1, 8, 64, 512, 1000, 10_000):
        parts = seconds(ranks, given)
        print(f"{ranks:6d} {messages(ranks):6.0f} {volume(ranks) / 1e3:7.0f}  " +
              " ".join(f"{1e3 * s:8.3f}" for s in parts) +
              f"  {parts[0] / sum(parts):.2f}  {memory(ranks) / 2.0**30:.2f}")
    most = (MEMORY - LIBRARIES - OWN * DOFS) / (REPLICATED * DOFS)
    print(f"4 GiB a rank last for {most:.0f} ranks, {most * DOFS / 1e6:.0f} million dofs")
    draw(given.folder, given)


if __name__ == "__main__":
    main()
