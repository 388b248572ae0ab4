"""The report of a run or a study: one HTML file that needs nothing else. docs/results.md describes it."""
