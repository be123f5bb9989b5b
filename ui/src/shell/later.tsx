import { useSignalEffect } from "@preact/signals";
import { House, RotateCw } from "lucide-preact";
import type { ComponentType } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { connection, problem, refreshStatus, report, wordsOf } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";

/** A part of the page whose code is not needed to begin with: it is fetched when the part is first shown. */
export function later<P extends object>(
  load: () => Promise<ComponentType<P>>,
  Failed: ComponentType | null = null,
): ComponentType<P> {
  let loaded: ComponentType<P> | null = null;
  return function Later(props: P) {
    const [, drawAgain] = useState(false);
    const [failed, setFailed] = useState(false);
    useEffect(() => {
      if (loaded) return;
      Promise.all([load(), import("../styles_later")]).then(
        ([part]) => {
          loaded = part;
          drawAgain(true);
        },
        (error) => {
          if (Failed) setFailed(true);
          else report(error);
        },
      );
    }, []);
    const Part = loaded;
    if (failed && Failed) return <Failed />;
    return Part ? <Part {...props} /> : null;
  };
}

/** A whole screen that is fetched when it is first shown. */
export function laterScreen<P extends object>(load: () => Promise<ComponentType<P>>) {
  return later(load, NotFetched);
}

/** A browser may remember that it could not fetch a part: only a new page asks again. */
function NotFetched() {
  const { trouble, saved } = texts.value;
  const again = async () => {
    await refreshStatus();
    if (connection.peek() === "open") location.reload();
    else waits.current = true;
  };
  const waits = useRef(false);
  useEffect(() => {
    void refreshStatus().then(() => {
      if (connection.peek() === "open") problem.value = wordsOf(null);
      else waits.current = true; // the line above says that the server is gone
    });
  }, []);
  useSignalEffect(() => {
    if (connection.value === "open" && waits.current) location.reload();
  });
  return (
    <main class="screen not-opened">
      <div class="not-opened__ways">
        <button
          type="button"
          class="button"
          data-testid={TEST.fetchAgain}
          onClick={() => void again()}
        >
          <RotateCw class="icon" aria-hidden="true" />
          {saved.retry}
        </button>
        <a class="button" href="#/">
          <House class="icon" aria-hidden="true" />
          {trouble.back}
        </a>
      </div>
    </main>
  );
}
