import { namedSign } from "./named_sign";

/** The camera that sees signs, and practising them. */
export const camera = {
  picture: "Imagem da câmera, como em um espelho",
  opening: "Abrindo a câmera…",
  choose: "Qual câmera usar",
  number: (n: number) => `Câmera ${n}`,
  other: "Outra fonte",
  showHand: "Mostrem a mão",
  noLetter: "A letra ainda não foi reconhecida",
  twoSigns: "Há duas mãos: mostrem uma só",
  unsure: "Ainda não é certo:",
  either: (one: string, other: string) => `${one} ou ${other}?`,
  orElse: (letter: string) => `ou ${letter}`,
  hold: "Mantenham a mão parada",
  sure: (sign: string, share: string) => `${namedSign(sign)}, com ${share} de certeza`,
  steady: "Quanto falta para o sinal valer",
  expected: "O programa espera:",
  sign: (sign: string) => `Desenho: ${namedSign(sign)}`,
  noDrawing: (sign: string) => `${namedSign(sign)}, ainda sem desenho`,
  hands: {
    left: "Desenhos da mão esquerda: trocar",
    right: "Desenhos da mão direita: trocar",
  },
};

export const practice = {
  hint: "Façam uma letra do alfabeto manual da Libras e mantenham a mão parada.",
  seen: "O que a câmera vê",
  spelled: "Pronto! Façam a próxima letra.",
  imitate: "Façam esta letra",
  choose: "Letra para fazer",
  hand: "Mão",
  right: "Direita",
  left: "Esquerda",
  matched: (sign: string) => `É isso! ${namedSign(sign)}.`,
  text: "O que vocês soletraram",
  placeholder: "As letras aparecem aqui",
  space: "Espaço",
  back: "Apagar letra",
  clear: "Limpar",
  bringBack: "Trazer de volta",
  moving:
    "A câmera ainda não conhece H, J, X, Z e Ç, que se mexem, nem Y: usem o teclado, ou ensinem essas letras (experimental). De K ela lê só a mão parada, sem o movimento.",
  credits:
    "Letras aprendidas de “Alfabeto em libras” (elainesilva, CC BY 4.0); mãos: MediaPipe (Apache 2.0).",
};

/** Signs that a class teaches the camera. */
export const teaching = {
  title: "Ensinar uma letra ou um sinal",
  name: "Letra, ou nome do sinal",
  record: "Gravar",
  samples: (n: number) => `${n} imagens`,
  forget: (sign: string) => `Apagar o que foi gravado de ${sign}`,
  counted: (sign: string, n: number, of: number) =>
    `${sign}: ${n} de ${of}. Mantenham a mão parada.`,
  kind: "Como é o sinal",
  still: "Fica parado",
  moves: "Se mexe",
  experimental: "experimental",
  suggested: "Letras que faltam",
  howStill: "Mantenham a mão parada até que dez imagens sejam gravadas.",
  howMoving: "Façam isto cinco vezes: parem a mão, façam o movimento e parem a mão de novo.",
  movements: (n: number) => (n === 1 ? "1 movimento" : `${n} movimentos`),
  countedMoving: (sign: string, n: number, of: number) =>
    `${sign}: ${n} de ${of}. Parem a mão, façam o movimento e parem a mão de novo.`,
  learnt: (sign: string) => `Pronto: a câmera conhece o sinal ${sign}.`,
};
