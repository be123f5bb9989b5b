"""What a layout does wrong, found by the boxes of the page's elements: cut texts, covered controls."""

from playwright.sync_api import Page

# Elements whose text is wider than the element, or that leave the window. Names of groups and
# classes may be shortened, with the whole name as a tooltip.
CUT = """() => {
  const cut = [];
  for (const element of document.querySelectorAll('body *')) {
    if (element.closest('svg, .injectionDiv, .blocklyWidgetDiv, .visually-hidden, option')) continue;
    const words = [...element.childNodes].filter((n) => n.nodeType === 3 && n.textContent.trim());
    const control = element.matches('button, a, select, input');
    if (!words.length && !control) continue;
    const box = element.getBoundingClientRect();
    const style = getComputedStyle(element);
    if (!box.width || style.visibility === 'hidden' || style.clipPath !== 'none') continue;
    if (element.matches('.header__group-name, .group-card__name, [data-shortened]')) continue;
    const scrolls = element.closest('[data-scrolls], pre');
    const name = element.dataset.testid ?? element.className;
    const what = `${element.tagName} ${name}: ${element.textContent.trim().slice(0, 40)}`;
    const wide = element.scrollWidth > element.clientWidth + 1;
    if (style.display !== 'inline' && wide) cut.push(`cut ${what}`);
    if (!scrolls && (box.right > innerWidth + 1 || box.left < -1)) cut.push(`outside ${what}`);
  }
  if (document.documentElement.scrollWidth > innerWidth) cut.push('the page scrolls sideways');
  return cut;
}"""
# Controls whose centre another element covers. The open mission may cover the floor, until the group begins; what an
# element that scrolls hides is not covered.
COVERED = """() => {
  const isHidden = ([element, x, y]) => {
    for (let at = element.parentElement; at; at = at.parentElement) {
      if (getComputedStyle(at).overflow === 'visible') continue;
      const box = at.getBoundingClientRect();
      if (x < box.left || x > box.right || y < box.top || y > box.bottom) return true;
    }
    return x < 0 || y < 0 || x > innerWidth || y > innerHeight;
  };
  return [...document.querySelectorAll('button, a, select, input')]
    .filter((e) => !e.closest('.visually-hidden, .injectionDiv, [data-scrolls]') && !e.disabled)
    .map((e) => [e, e.getBoundingClientRect()])
    .filter(([e, box]) => box.width && box.height && e.checkVisibility({ visibilityProperty: true }))
    .map(([e, box]) => [e, box.x + box.width / 2, box.y + box.height / 2])
    .filter((one) => !isHidden(one))
    .map(([e, x, y]) => [e, document.elementFromPoint(x, y)])
    .filter(([e, hit]) => !hit?.closest('[data-testid=mission-sheet]'))
    .filter(([e, hit]) => hit && !(e.contains(hit) || hit.closest('label')?.contains(e)))
    .map(([e, hit]) => `${e.dataset.testid ?? e.ariaLabel ?? e.className} under ${hit?.className}`);
}"""
# Pairs of controls whose visible parts overlap: what an element that scrolls hides does not count.
_OVERLAPPING = """() => {
  const visible = (element) => {
    let { left, right, top, bottom } = element.getBoundingClientRect();
    for (let at = element.parentElement; at; at = at.parentElement) {
      if (getComputedStyle(at).overflow === 'visible') continue;
      const box = at.getBoundingClientRect();
      [left, right] = [Math.max(left, box.left), Math.min(right, box.right)];
      [top, bottom] = [Math.max(top, box.top), Math.min(bottom, box.bottom)];
    }
    return { element, left, right, top, bottom };
  };
  const shared = (one, other, from, to) => Math.min(one[to], other[to]) - Math.max(one[from], other[from]);
  const nameOf = ({ element }) => element.dataset.testid ?? element.ariaLabel ?? element.className;
  const controls = [...document.querySelectorAll('button, a, select, input, textarea, [role=slider]')]
    .filter((e) => !e.closest('.visually-hidden, .injectionDiv') && e.checkVisibility({ visibilityProperty: true }))
    .map(visible);
  const found = [];
  for (const [index, one] of controls.entries()) for (const other of controls.slice(index + 1)) {
    if (one.element.contains(other.element) || other.element.contains(one.element)) continue;
    if (one.element.closest('label')?.contains(other.element)) continue;
    if (shared(one, other, 'left', 'right') > 3 && shared(one, other, 'top', 'bottom') > 3)
      found.push(`${nameOf(one)} over ${nameOf(other)}`);
  }
  return found;
}"""


def layout_faults(page: Page) -> list[str]:
    """Returns texts that are cut, controls that leave the window, and controls that cover each other."""
    return [one for check in (CUT, COVERED, _OVERLAPPING) for one in page.evaluate(check)]
