import type { ComponentChildren } from "preact";
import type { Ready } from "./load_state";
import { NotLoaded } from "./NotLoaded";
import type { Loadable } from "./useLoaded";

interface LoadedProps<T> {
  of: Loadable<T>;
  /** A whole screen, or a part of one. */
  as?: "screen" | "part";
  /** Text while loading. */
  loading?: string | undefined;
  /** Shown for an empty list. */
  empty?: ComponentChildren;
  /** Actions beside "try again"; on a screen by default the link to the start. */
  actions?: ComponentChildren;
  children(value: T, loaded: Ready<T>): ComponentChildren;
}

/** Draws a loaded value, or its loading or failed state. */
export function Loaded<T>({ of, as = "part", loading, empty, actions, children }: LoadedProps<T>) {
  if (of.status === "failed") {
    return <NotLoaded as={as} busy={of.busy} again={of.reload} actions={actions} />;
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
