import { useSignalEffect } from "@preact/signals";
import { RotateCw } from "lucide-preact";
import type { ComponentType } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { fetchLaterTexts, texts } from "../i18n";
import { Button } from "../kit/Button";
import { wordsOf } from "../kit/requests/problem";
import { ToStart } from "../kit/ToStart";
import { connection, problem, refreshStatus, report } from "./session";
import { TEST } from "./testids";

/** Fetches a part that is not needed to begin with, and what all such parts need. */
export async function fetchPart<Part>(load: () => Promise<Part>): Promise<Part> {
  const [part] = await Promise.all([load(), import("../styles_later"), fetchLaterTexts()]);
  return part;
}

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
    <main class="screen waiting">
      <div class="waiting__ways">
        <Button icon={RotateCw} testId={TEST.fetchAgain} onPress={again}>
          {texts.value.saved.retry}
        </Button>
        <ToStart />
      </div>
    </main>
  );
}
