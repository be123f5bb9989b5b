import { fetchPart } from "../shell/later";
import { parse, ROUTES } from "../shell/route";
import { connection } from "../shell/session";

/** Whoever points at a link, or comes to it by the keyboard, is likely to follow it: its screen is fetched then. */
function fetchAhead({ target }: Event): void {
  const link =
    target instanceof Element ? target.closest<HTMLAnchorElement>("a[href^='#/']") : null;
  const load = link && ROUTES[parse(link.hash).screen].load;
  // a browser may remember what it could not fetch
  if (load && connection.peek() === "open") fetchPart(load).catch(() => {});
}

document.addEventListener("pointerover", fetchAhead);
document.addEventListener("focusin", fetchAhead);
