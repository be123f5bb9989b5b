import { useEffect } from "preact/hooks";

/** Names the screen for the rules of its paper, which hide all around it. */
export function usePrintedPage(name: "plan" | "cards"): void {
  useEffect(() => {
    document.documentElement.dataset.page = name;
    return () => {
      delete document.documentElement.dataset.page;
    };
  }, [name]);
}
