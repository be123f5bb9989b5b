import type { ComponentChildren } from "preact";
import type { Ready } from "./load_state";
import { NotLoaded } from "./NotLoaded";
import type { Loadable } from "./useLoaded";

interface LoadedProps<T> {
  of: Loadable<T>;
  /** A whole screen, or a part of one. */
  as?: "screen" | "part";
  /** Words while it is on its way. */
  loading?: string | undefined;
  /** Stands where a list has nothing in it. */
  empty?: ComponentChildren;
  /** Ways on beside trying again; for a screen the way to the start unless there are others. */
  ways?: ComponentChildren;
  children(value: T, loaded: Ready<T>): ComponentChildren;
}

/** What was loaded; until then that it is on its way, or that it failed and how to try again. */
export function Loaded<T>({ of, as = "part", loading, empty, ways, children }: LoadedProps<T>) {
  if (of.status === "failed") {
    return <NotLoaded as={as} busy={of.busy} again={of.again} ways={ways} />;
  }
  if (of.status === "ready") {
    const isEmpty = Array.isArray(of.value) && of.value.length === 0 && empty !== undefined;
    return <>{isEmpty ? empty : children(of.value, of)}</>;
  }
  const Place = as === "screen" ? "main" : "div";
  return (
    <Place class={as === "screen" ? "screen waiting" : "waiting"} aria-busy="true">
      {loading && <p>{loading}</p>}
    </Place>
  );
}
