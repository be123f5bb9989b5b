import { useSignalEffect } from "@preact/signals";
import { RotateCw } from "lucide-preact";
import type { ComponentType } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { fetchLazyTexts, texts } from "../i18n";
import { Button } from "../kit/Button";
import { problemOf } from "../kit/requests/problem";
import { ToStart } from "../kit/ToStart";
import { connection, problem, refreshStatus, report } from "./session";

let fetchStyles: () => Promise<unknown> = async () => {};

/**
 * Sets the function that fetches the styles of all lazy parts. The shell does not import these
 * styles, because it must not import the parts.
 */
export function setLazyStyles(fetch: () => Promise<unknown>): void {
  fetchStyles = fetch;
}

/** Imports a lazy part, together with the texts and styles of all lazy parts. */
export async function fetchPart<Part>(load: () => Promise<Part>): Promise<Part> {
  const [part] = await Promise.all([load(), fetchStyles(), fetchLazyTexts()]);
  return part;
}

/** A lazy component: its code is imported when it is first shown. */
export function lazy<P extends object>(
  load: () => Promise<ComponentType<P>>,
  Failed: ComponentType<P> | null = null,
): ComponentType<P> {
  let loaded: ComponentType<P> | null = null;
  return function Lazy(props: P) {
    const [, drawAgain] = useState(false);
    const [failed, setFailed] = useState(false);
    const Part = loaded;
    useEffect(() => {
      if (Part) return;
      fetchPart(load).then(
        (part) => {
          loaded = part;
          drawAgain(true);
        },
        (error) => {
          if (Failed) setFailed(true);
          else report(error);
        },
      );
    }, []);
    if (failed && Failed) return <Failed {...props} />;
    return Part ? <Part {...props} /> : null;
  };
}

/** A lazy screen. */
export function lazyScreen<P extends object>(load: () => Promise<ComponentType<P>>) {
  return lazy(load, NotFetched);
}

/** Offers a reload of the page: browsers may cache a failed import, so importing again may not help. */
function NotFetched() {
  const again = async () => {
    await refreshStatus();
    if (connection.peek() === "open") location.reload();
    else waits.current = true;
  };
  const waits = useRef(false);
  useEffect(() => {
    void refreshStatus().then(() => {
      if (connection.peek() === "open") problem.value = problemOf(null);
      else waits.current = true; // the line under the header reports the lost server
    });
  }, []);
  useSignalEffect(() => {
    if (connection.value === "open" && waits.current) location.reload();
  });
  return (
    <main class="screen waiting">
      <div class="waiting__ways">
        <Button icon={RotateCw} testId="fetch-again" onPress={again}>
          {texts.value.saved.retry}
        </Button>
        <ToStart />
      </div>
    </main>
  );
}
