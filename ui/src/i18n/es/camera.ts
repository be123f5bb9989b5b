import { namedSign } from "./named_sign";

/** The camera that sees signs, and practising them. */
export const camera = {
  picture: "Imagen de la cámara, como en un espejo",
  opening: "Abriendo la cámara…",
  choose: "Qué cámara usar",
  number: (n: number) => `Cámara ${n}`,
  other: "Otra fuente",
  showHand: "Muestren la mano",
  noLetter: "La letra todavía no se reconoció",
  twoSigns: "Hay dos manos: muestren una sola",
  unsure: "Todavía no es seguro:",
  either: (one: string, other: string) => `¿${one} o ${other}?`,
  orElse: (letter: string) => `o ${letter}`,
  hold: "Mantengan la mano quieta",
  sure: (sign: string, share: string) => `${namedSign(sign)}, con ${share} de certeza`,
  steady: "Cuánto falta para que la seña valga",
  expected: "El programa espera:",
  sign: (sign: string) => `Dibujo: ${namedSign(sign)}`,
  noDrawing: (sign: string) => `${namedSign(sign)}, todavía sin dibujo`,
  hands: {
    left: "Dibujos de la mano izquierda: cambiar",
    right: "Dibujos de la mano derecha: cambiar",
  },
};

export const practice = {
  hint: "Hagan una letra del alfabeto manual de Libras y mantengan la mano quieta.",
  seen: "Lo que ve la cámara",
  spelled: "¡Listo! Hagan la letra siguiente.",
  imitate: "Hagan esta letra",
  choose: "Letra para hacer",
  hand: "Mano",
  right: "Derecha",
  left: "Izquierda",
  matched: (sign: string) => `¡Eso es! ${namedSign(sign)}.`,
  text: "Lo que deletrearon",
  placeholder: "Las letras aparecen aquí",
  space: "Espacio",
  back: "Borrar letra",
  clear: "Limpiar",
  bringBack: "Traer de vuelta",
  moving:
    "La cámara todavía no conoce H, J, X, Z y Ç, que se mueven, ni Y: usen el teclado, o enseñen esas letras (experimental). De K lee solo la mano quieta, sin el movimiento.",
  credits:
    "Letras aprendidas de “Alfabeto em libras” (elainesilva, CC BY 4.0); manos: MediaPipe (Apache 2.0).",
};

/** Signs that a class teaches the camera. */
export const teaching = {
  title: "Enseñar una letra o una seña",
  name: "Letra, o nombre de la seña",
  record: "Grabar",
  samples: (n: number) => `${n} imágenes`,
  forget: (sign: string) => `Borrar lo que se grabó de ${sign}`,
  counted: (sign: string, n: number, of: number) =>
    `${sign}: ${n} de ${of}. Mantengan la mano quieta.`,
  kind: "Cómo es la seña",
  still: "Queda quieta",
  moves: "Se mueve",
  experimental: "experimental",
  suggested: "Letras que faltan",
  howStill: "Mantengan la mano quieta hasta que se graben diez imágenes.",
  howMoving: "Hagan esto cinco veces: paren la mano, hagan el movimiento y paren la mano otra vez.",
  movements: (n: number) => (n === 1 ? "1 movimiento" : `${n} movimientos`),
  countedMoving: (sign: string, n: number, of: number) =>
    `${sign}: ${n} de ${of}. Paren la mano, hagan el movimiento y paren la mano otra vez.`,
  learnt: (sign: string) => `Listo: la cámara conoce la seña ${sign}.`,
};
