// Made by `python -m scripts.reference` from pinel_desktop/activities/checks/. Do not edit.

/** What the teacher chooses of each kind of check that the form offers, in its order. */
export const CHECK_FIELDS = {
  ends_in: [{ key: "zone", input: "zone" }],
  ends_at: [{ key: "within_m", input: "number", label: "cm", min: 1, max: 500, step: 1, factor: 100 }],
  visits: [{ key: "zones", input: "shown" }],
  avoids: [{ key: "zone", input: "zone" }],
  touches_nothing: [],
  draws: [{ key: "tolerance", input: "number", label: "cm", min: 2, max: 100, step: 1, factor: 100 }],
  closed: [{ key: "within_m", input: "number", label: "cm", min: 1, max: 500, step: 1, factor: 100 }],
  turned_total: [{ key: "at_least_deg", input: "number", label: "least", min: 0, max: 100000, step: 5, factor: 1 }, { key: "at_most_deg", input: "number", label: "most", min: 1, max: 100000, step: 5, factor: 1 }],
  path_length: [{ key: "at_least_m", input: "number", label: "least", min: 0, max: 10000, step: 0.1, factor: 1 }, { key: "at_most_m", input: "number", label: "most", min: 0.1, max: 10000, step: 0.1, factor: 1 }],
  block_count: [{ key: "at_most", input: "number", label: "most", min: 1, max: 1000, step: 1, factor: 1 }],
  nesting: [{ key: "at_least", input: "fixed", value: 1 }],
  time: [{ key: "at_most_s", input: "number", label: "most", min: 1, max: 1000, step: 1, factor: 1 }],
  says: [{ key: "text", input: "text" }],
  mark_count: [{ key: "n", input: "number", label: "n", min: 1, max: 1000, step: 1, factor: 1 }],
} as const;
